#!/bin/bash
# Copyright (c) 2026 The Quad_mesh_adaptation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# build.sh FOLDER TARGETS [CMAKE OPTIONS ...]
# Configures into build/FOLDER and builds the targets (separated by blanks), with as many jobs as
# there are processors and memory for.

set -euo pipefail
cd "$(dirname "$0")/.."

folder=build/$1
read -ra targets <<<"$2"
shift 2

memory=$(awk '/^MemAvailable/ { print int($2 / 1500000) }' /proc/meminfo) # 1.5 GB for each compiler
jobs=$(nproc)
[[ $memory -ge $jobs ]] || jobs=$((memory > 1 ? memory : 1))

# ccache is not to preprocess what is new to it, and to work with precompiled headers.
export CCACHE_DEPEND=1 CCACHE_SLOPPINESS=pch_defines,time_macros

mkdir -p build
echo "Building ${targets[*]} in $folder with $jobs job(s) ..."
cmake -S . -B "$folder" -G Ninja "$@" >"$folder.log" 2>&1 || { cat "$folder.log"; exit 1; }
grep 'is not built' "$folder.log" || true
cmake --build "$folder" -j "$jobs" --target "${targets[@]}"
