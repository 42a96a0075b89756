#!/bin/bash
# Copyright (c) 2026 The Quad_mesh_adaptation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# speed_report.sh               times 1e3 to 1e5 faces, writes doc/Quad_mesh_adaptation/speed.md and
#                               its plots; Gmsh takes part where it is on the PATH
# speed_report.sh --large       up to 1e7 faces, which takes hours and 16 GB
# speed_report.sh --only TEXT   only the tasks whose name holds TEXT ("adapt/plate", "/1e4"), into
#                               build/speed; may be given several times, also behind --large
# speed_report.sh --runs N      at most N runs of each task, instead of 5 (1 to 3 of long ones)

set -euo pipefail
cd "$(dirname "$0")/.."

if [[ ${1:-} == --help ]]; then
  sed -n '/^# speed_report.sh/,/^$/s/^# //p' "$0"
  exit 0
fi
folder=doc/Quad_mesh_adaptation
for argument in "$@"; do
  [[ $argument != --only ]] || folder=build/speed # of some tasks only: not for the manual
done

scripts/install_dependencies.sh libbenchmark-dev
scripts/build.sh release speed -DCMAKE_BUILD_TYPE=Release -DQUAD_MESH_ADAPTATION_BENCHMARKS=ON
program=build/release/benchmark/Quad_mesh_adaptation/speed
"$program" "$folder" "$@"
echo "The report is $folder/speed.md, its plots are $folder/fig/speed_*.svg"
