#!/bin/bash
# Copyright (c) 2026 The Quad_mesh_adaptation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test.sh              installs what is missing, builds the tests in build/release, runs them all
# test.sh --headers    compiles every header on its own as well
# test.sh --sanitize   tests of memory and topology with the address and undefined-behaviour sanitizers
# test.sh --cgal6      public headers, some examples and tests of the interfaces of CGAL with CGAL 6
# test.sh --sanitize --all, --cgal6 --all   the same with the whole core of the tests, about twice as
#                      many, and all examples
# test.sh --long       more than 1000 random runs instead, an hour or two; QUAD_MESH_SEED repeats them

set -euo pipefail
cd "$(dirname "$0")/.."

folder=release
targets="all"
options=(-DCMAKE_BUILD_TYPE=Release)
label=""
left_out="" # patterns of tests
slow=""     # the same, but for --all
selection=()
is_long=no
is_whole_core=no
for argument in "$@"; do
  case $argument in
    --headers)
      targets="all header_checks"
      options+=(-DQUAD_MESH_ADAPTATION_HEADER_CHECKS=ON)
      ;;
    --sanitize)
      folder=sanitize
      label=sanitize
      targets=""
      options+=(-DCMAKE_BUILD_TYPE=None "-DCMAKE_CXX_FLAGS=-O1 -g1"
        -DQUAD_MESH_ADAPTATION_TEST_OPTIONS=-O0
        -DQUAD_MESH_ADAPTATION_SANITIZE=ON -DQUAD_MESH_ADAPTATION_EXAMPLES=OFF)
      # but for some that take long there and do much that others do as well
      left_out="Adapt_region.RefinedOnSurfaceMesh|Distance.BoundIsMetOrTheFacesAreNamed"
      slow="AsNearAsPossible|SurfaceMeshCartesian|NodesAstray"
      slow+="|Graded/(torus|saddle|sphere|irregular|valences|slab_of_genus_.|open_cylinder|disk)"
      slow+="|Adapt_quad_mesh.(Polyhedron|SurfaceMeshEpick|StraightBorders|FeatureAngle)"
      slow+="|Threads.Single_phases|Smooth_reference.(TenTimesNearer|CylinderWithRims)"
      ;;
    --cgal6)
      folder=cgal6_tests
      label=cgal6
      targets="public_header_checks quad_adapt features_example curvature_sizing_example"
      targets+=" region_example projector_example"
      options+=(-DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_FLAGS=-O1
        -DQUAD_MESH_ADAPTATION_TEST_OPTIONS=-O0 -DQUAD_MESH_ADAPTATION_HEADER_CHECKS=ON)
      slow="Adapt_region.RefinedOnSurfaceMesh|BoundIsMetOrTheFacesAreNamed|RoundsOnABracket"
      ;;
    --all)
      is_whole_core=yes
      ;;
    --long)
      is_long=yes
      targets="test_random_sizes test_random_operations"
      ;;
    *)
      sed -n '/^# test.sh/s/^# //p' "$0"
      [[ $argument == --help ]] && exit 0
      exit 2
      ;;
  esac
done

if [[ -n $label && $is_whole_core == yes ]]; then
  label=core
  slow=""
  targets=${targets:+$targets examples}
fi
[[ -z $slow ]] || left_out+=${left_out:+|}$slow
[[ -z $left_out ]] || selection+=(-E "$left_out")
if [[ -n $label ]]; then
  targets+=" ${label}_tests"
  selection+=(-L "$label")
fi

scripts/install_dependencies.sh
if [[ $folder == cgal6_tests ]]; then
  cgal_dir=$(scripts/get_cgal6.sh)
  options+=("-DCGAL_DIR=$cgal_dir")
fi
scripts/build.sh $folder "$targets" "${options[@]}"

if [[ $is_long == yes ]]; then
  # each run prints its seed: 25 seeds on each shape of the zoo, for each kind of size
  export QUAD_MESH_SEED=${QUAD_MESH_SEED:-$RANDOM}
  export QUAD_MESH_RUNS=${QUAD_MESH_RUNS:-25} QUAD_MESH_STEPS=${QUAD_MESH_STEPS:-2000}
  for test in $targets; do
    "build/$folder/test/Quad_mesh_adaptation/$test"
  done | tee "build/$folder/long.log"
  exit
fi

echo "Running the tests in build/$folder ..."
export UBSAN_OPTIONS=print_stacktrace=1
[[ $folder != sanitize ]] || export QUAD_MESH_ROUNDS=${QUAD_MESH_ROUNDS:-3} # of ten: slow there
ctest --test-dir "build/$folder" --output-on-failure -j "$(nproc)" --no-tests=error \
  "${selection[@]}" | tee "build/$folder/ctest.log"
