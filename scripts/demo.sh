#!/bin/bash
# Copyright (c) 2026 The Quad_mesh_adaptation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs what is missing, builds the examples and adapts the three meshes of the paper:
# the plate under a circular load, the nosecone, and the quarter plate with a hole.

set -euo pipefail
cd "$(dirname "$0")/.."

cases=(circular_load_example nosecone_example plate_with_hole_example)
results=build/demo

scripts/install_dependencies.sh
scripts/build.sh release "${cases[*]} quad_adapt" -DCMAKE_BUILD_TYPE=Release
mkdir -p "$results"
for case in "${cases[@]}"; do
  echo
  echo "=== $case ==="
  "build/release/examples/Quad_mesh_adaptation/$case" "$results"
done

echo
echo "Meshes (.off, .vtk) and pictures (.svg) are in $results:"
ls "$results"
echo "The program for meshes of your own: build/release/examples/Quad_mesh_adaptation/quad_adapt --help"
