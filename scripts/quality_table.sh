#!/bin/bash
# Copyright (c) 2026 The Quad_mesh_adaptation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# quality_table.sh               measures the usual cases, writes build/quality_table.md
# quality_table.sh --long        also those of 1e5 faces and more
# quality_table.sh --huge        also that of 1e6 faces, which takes long
# quality_table.sh --only TEXT   only the cases whose name holds TEXT
# quality_table.sh --ablation    leaves out the ingredients of the default schedule one by one,
#                                writes doc/Quad_mesh_adaptation/ablation.md; with --only TEXT
#                                some cases, into build/ablation.md
# quality_table.sh --pictures    draws what both schedules make of the paper's cases, and the
#                                convergence of the finite-element loop, into
#                                doc/Quad_mesh_adaptation/fig

set -euo pipefail
cd "$(dirname "$0")/.."

if [[ ${1:-} == --help ]]; then
  sed -n '/^# quality_table.sh/,/^$/s/^# //p' "$0"
  exit 0
fi
doc=doc/Quad_mesh_adaptation
programs=build/release/benchmark/Quad_mesh_adaptation
mode=${1:-}
case $mode in
--ablation) targets=ablation ;;
--pictures) targets="quality_table adaptive_loop_example" ;;
*) targets=quality_table ;;
esac
scripts/install_dependencies.sh
scripts/build.sh release "$targets" -DCMAKE_BUILD_TYPE=Release -DQUAD_MESH_ADAPTATION_BENCHMARKS=ON

case $mode in
--ablation)
  table=$doc/ablation.md
  [[ $# -eq 1 ]] || table=build/ablation.md # of some cases only: not for the manual
  "$programs/ablation" "$table" "${@:2}"
  echo "The table is $table"
  ;;
--pictures)
  pictures=build/pictures
  rm -rf "$pictures" && mkdir -p "$pictures"
  "$programs/quality_table" "$pictures/table.md" --only "k = 1" --pictures "$pictures"
  build/release/examples/Quad_mesh_adaptation/adaptive_loop_example "$pictures"
  if ! command -v rsvg-convert >/dev/null; then
    echo "The pictures are $pictures/*.svg; install librsvg2-bin for those of the manual (PNG)"
    exit 1
  fi
  for picture in "$pictures"/schedules_*.svg; do
    rsvg-convert -w 1200 -b white "$picture" -o "$doc/fig/$(basename "$picture" .svg).png"
  done
  rsvg-convert -b white "$pictures/convergence.svg" -o "$doc/fig/convergence.png"
  ls -l "$doc"/fig
  ;;
*)
  "$programs/quality_table" build/quality_table.md "$@"
  echo "The table is build/quality_table.md; for the manual copy it to $doc/quality.md"
  ;;
esac
