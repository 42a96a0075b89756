#!/bin/bash
# Copyright (c) 2026 The Quad_mesh_adaptation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# quality_table.sh               measures the default cases, writes build/quality_table.md
# quality_table.sh --long        also those of 1e5 faces and more
# quality_table.sh --only TEXT   only the cases whose name holds TEXT

set -euo pipefail
cd "$(dirname "$0")/.."

if [[ ${1:-} == --help ]]; then
  sed -n '/^# quality_table.sh/s/^# //p' "$0"
  exit 0
fi
scripts/install_dependencies.sh
scripts/build.sh release quality_table -DCMAKE_BUILD_TYPE=Release \
  -DQUAD_MESH_ADAPTATION_BENCHMARKS=ON
build/release/benchmark/Quad_mesh_adaptation/quality_table build/quality_table.md "$@"
echo "The table is build/quality_table.md; for the manual copy it to"
echo "doc/Quad_mesh_adaptation/quality.md"
