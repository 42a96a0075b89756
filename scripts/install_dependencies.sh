#!/bin/bash
# Copyright (c) 2026 The Quad_mesh_adaptation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# install_dependencies.sh [PACKAGE ...]
# Installs the Debian packages that the examples and the tests need, and those named.  Says nothing
# when all are there.

set -euo pipefail

packages=(
  g++ cmake ninja-build ccache # build
  libcgal-dev                  # the package itself (brings Boost, GMP and MPFR)
  libeigen3-dev                # finite elements of the plate with a hole
  libcli11-dev nlohmann-json3-dev libmuparser-dev # the program quad_adapt
  libtbb-dev                   # threads
  libgtest-dev                 # tests
  "$@"
)

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $status == installed ]] || missing+=("$package")
done
[[ ${#missing[@]} -gt 0 ]] || exit 0

as_root=()
if [[ $EUID -ne 0 ]]; then
  if ! command -v sudo >/dev/null; then
    echo "Missing packages: ${missing[*]}" >&2
    echo "Install them as root, or install sudo." >&2
    exit 1
  fi
  as_root=(sudo)
fi

echo "Installing ${missing[*]} ..."
"${as_root[@]}" apt-get update -qq || echo "apt-get update failed in part, going on" >&2
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
