#!/bin/bash
# Copyright (c) 2026 The Quad_mesh_adaptation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Puts the headers of CGAL 6 (of Debian's release "trixie") into build/cgal6, next to the installed
# CGAL.  Uses the package manager with the machine's own Debian archive, and changes nothing outside
# that folder.  The last line of output is the folder to give to CMake as CGAL_DIR.

set -euo pipefail
cd "$(dirname "$0")/.."

suite=trixie
folder=$PWD/build/cgal6

cgal_dir()
{
  compgen -G "$folder/root/usr/lib/*/cmake/CGAL" | head -n 1
}

if [[ -n $(cgal_dir) ]]; then
  cgal_dir
  exit 0
fi

echo "Fetching CGAL 6 from Debian's $suite into build/cgal6 ..." >&2
rm -rf "$folder"
mkdir -p "$folder"/{lists/partial,cache/archives/partial,root}

# The main archive of this machine, with another suite.  Both formats of apt's sources are known.
codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
for file in /etc/apt/sources.list.d/*.sources; do
  [[ -f $file ]] || continue
  awk -v codename="$codename" -v suite="$suite" '
    BEGIN { RS = ""; FS = "\n" }
    {
      stanza = ""; is_main = 0
      for(i = 1; i <= NF; ++i) {
        if($i ~ /^#/) continue
        if($i ~ /^Suites:/) {
          if($i ~ ("[ \t]" codename "([ \t]|$)")) is_main = 1
          $i = "Suites: " suite
        }
        stanza = stanza $i "\n"
      }
      if(is_main) print stanza
    }' "$file"
done >"$folder/$suite.sources"
list=$folder/$suite.sources
if [[ ! -s $list ]]; then
  list=$folder/$suite.list
  cat /etc/apt/sources.list /etc/apt/sources.list.d/*.list 2>/dev/null |
    sed -nE "s/^(deb[[:space:]].*[[:space:]])$codename([[:space:]]+main)/\1$suite\2/p" |
    sort -u >"$list" || true
fi
if [[ ! -s $list ]]; then
  echo "No Debian archive for '$codename' found in apt's sources" >&2
  exit 1
fi

apt_options=(
  -o Dir::Etc::sourcelist="$list" -o Dir::Etc::sourceparts=/dev/null
  -o Dir::State::lists="$folder/lists" -o Dir::Cache="$folder/cache"
  -o APT::Sandbox::User="$(id -un)" -o Acquire::Languages=none
)
apt-get "${apt_options[@]}" update -qq >&2
(cd "$folder" && apt-get "${apt_options[@]}" download -qq libcgal-dev >&2)
dpkg -x "$folder"/libcgal-dev_*.deb "$folder/root"
rm -rf "$folder/lists" "$folder/cache" "$folder"/*.deb
if [[ -z $(cgal_dir) ]]; then
  echo "The package holds no CMake configuration of CGAL" >&2
  exit 1
fi
cgal_dir
