#!/usr/bin/env bash
# Copyright (c) 2026 The Quad_mesh_adaptation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# test_program.sh PATH_OF_QUAD_ADAPT
# Runs the program through all its exit codes, and checks that a refusal says why in one line on
# the error stream and writes nothing.
set -u
program=$(realpath "${1:?usage: test_program.sh PATH_OF_QUAD_ADAPT}")
meshes=$(realpath "$(dirname "$0")/../../data/meshes")
manual=$(realpath "$(dirname "$0")/../../doc/Quad_mesh_adaptation/Quad_mesh_adaptation.txt")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
failures=0
checks=0

fail() {
  failures=$((failures + 1))
  printf 'FAILED: %s\n' "$*"
  [ -s .err ] && sed 's/^/    /' .err
}

# grid N: a square of N x N unit quads as OFF
grid() {
  awk -v n="$1" 'BEGIN {
    print "OFF\n" (n+1)*(n+1), n*n, 0
    for(j = 0; j <= n; ++j) for(i = 0; i <= n; ++i) print i, j, 0
    for(j = 0; j < n; ++j) for(i = 0; i < n; ++i)
      print 4, j*(n+1)+i, j*(n+1)+i+1, (j+1)*(n+1)+i+1, (j+1)*(n+1)+i }'
}
listing() { find . -type f ! -name '.out' ! -name '.err' ! -name '.report' -exec md5sum {} + | sort; }

# expect CODE PATTERN ARGUMENTS...: exit code, error stream matching; nothing written unless 0 or 3
expect() {
  local code=$1 pattern=$2 before after status
  shift 2
  checks=$((checks + 1))
  before=$(listing)
  "$program" "$@" >.out 2>.err
  status=$?
  after=$(listing)
  [ "$status" -eq "$code" ] || fail "exit code $status instead of $code: quad_adapt $*"
  [ -z "$pattern" ] || grep -qiE -e "$pattern" .err || fail "the message does not match '$pattern': quad_adapt $*"
  case $code in
    0 | 3) ;;
    *)
      [ "$before" = "$after" ] || fail "something was written: quad_adapt $*"
      [ "$(grep -c '' .err)" -eq 1 ] || fail "not one line of message: quad_adapt $*"
      ;;
  esac
}
# refuse_with_report STATUS REASON PATTERN ARGUMENTS...: the report alone is written, and says why
refuse_with_report() {
  local status=$1 reason=$2 pattern=$3 before
  shift 3
  checks=$((checks + 1))
  rm -f report.json
  before=$(listing)
  "$program" "$@" --report report.json >.out 2>.err
  [ $? -eq 1 ] || fail "the exit code is not 1: quad_adapt $*"
  [ "$(grep -c '' .err)" -eq 1 ] || fail "not one line of message: quad_adapt $*"
  grep -q "\"status\": \"$status\"" report.json && grep -q "\"reason\": \"$reason\"" report.json &&
    grep -qiE "\"message\": \".*$pattern" report.json ||
    fail "report.json does not say $status, $reason and $pattern: quad_adapt $*"
  mv report.json .report
  [ "$before" = "$(listing)" ] || fail "more than the report was written: quad_adapt $*"
}
# refuse PATTERN TEXT_OF_OFF: a refused input
refuse() {
  printf '%b' "$2" >bad.off
  expect 1 "$1" bad.off out.off --size 1 --picture picture.svg
  refuse_with_report input_refused '[a-z_]*' "$1" bad.off out.off --size 1 --picture picture.svg
}
wrote() { for file in "$@"; do [ -s "$file" ] || fail "$file was not written"; done; }

grid 4 >plate.off
square='0 0 0\n1 0 0\n1 1 0\n0 1 0\n'

# sizes met: all files there, all formats, input untouched
sum=$(md5sum <plate.off)
expect 0 '' plate.off out.off --size 1
wrote out.off
[ "$(head -n 1 out.off)" = OFF ] || fail "out.off is no OFF file"
grep -q 'Size ratio' .out || fail "no table was printed"
for format in obj ply vtk vtu; do
  expect 0 '' plate.off "out.$format" --size 0.6 --quiet
  wrote "out.$format"
  [ -s .out ] && fail "--quiet printed something"
done
expect 0 '' out.obj again.ply --size 1 --quiet
expect 0 '' out.ply again.off --size 1 --quiet
expect 0 '' plate.off out.off --size-function '0.5 + 0.1 * hypot(x, y)' --report report.json \
  --picture picture.svg --schedule default --feature-angle 40 --max-iterations 20 --quiet
wrote out.off report.json picture.svg
grep -q '"status": "sizes_met"' report.json || fail "report.json does not say sizes_met"
grep -q '<svg' picture.svg || fail "picture.svg is no picture"
if command -v python3 >.out; then
  python3 -c 'import json, sys, xml.dom.minidom
r = json.load(open("report.json")); xml.dom.minidom.parse("picture.svg")
xml.dom.minidom.parse("out.vtu")
faces = int(open("out.off").read().split()[2])
sys.exit(not (r["after"]["faces"] == faces == sum(r["after"]["size_ratio"]["faces"].values())))' ||
    fail "report.json, picture.svg, out.vtu and out.off do not agree or are not well formed"
fi
grid 8 | awk 'NR > 2 && NF == 3 { print $1 / 2, $2 / 2, $3; next } { print }' >fine.off
expect 0 '' plate.off out.off --size 0.8 --reference fine.off --quiet
# threads change nothing, nor do they disturb an expression
if "$program" --help | grep -q -- --threads; then
  for threads in 1 2; do
    expect 0 '' fine.off "with_$threads.off" --size-function '0.06 + 0.02 * x' \
      --threads "$threads" --quiet
  done
  cmp with_1.off with_2.off || fail "the result depends on the number of threads"
  expect 2 'threads' fine.off out.off --size 1 --threads 0
fi
# what was put right in the input is said
printf '%b' "OFF\n5 1 0\n${square}9 9 9\n4 0 1 2 3\n" >lonely.off
expect 0 'note: .*1 vertex that no face uses' lonely.off out.off --size 1
# the number of faces is said before the work, and is right where it is small
awk 'NR > 2 && NF == 3 { print $1, $2, 0.2 * $1 * $1; next } { print }' plate.off >bowl.off
for size in 1.7 2.1 0.9; do
  expect 0 '' bowl.off few.off --size "$size" --report few.json
  said=$(sed -n '1s/^Faces expected beforehand //p' .out)
  [ "$said" = "$(awk 'NR == 2 { print $2 }' few.off)" ] ||
    fail "'$said' faces were foretold first, not $(awk 'NR == 2 { print $2 }' few.off)"
  grep -q "\"expected_number_of_faces\": $said\.0" few.json || fail "few.json foretells others"
done
# a size that jumps is graded: said, and many more faces; a gentle one stays as it is
faces() { awk 'NR == 2 { print $2 }' "$1"; }
expect 0 '' plate.off jump.off --size-function 'x < 1 ? 0.1 : 2' --quiet
expect 0 'lowered on .* % of the surface' plate.off graded.off \
  --size-function 'x < 1 ? 0.1 : 2' --gradation 0.2
[ "$(faces graded.off)" -gt "$(($(faces jump.off) + 50))" ] || fail "--gradation changed nothing"
expect 0 '' plate.off gentle.off --size-function '0.3 + 0.1 * x' --gradation 0.2
[ -s .err ] && fail "--gradation lowered a gentle size"
# sizes from elsewhere: the smallest counts, and the bounds hold
cat >wanted.ply <<'PLY'
ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
property float size
element face 1
property list uchar int vertex_indices
end_header
0 0 0 0.25
4 0 0 1
4 4 0 1
0 4 0 0.25
4 0 1 2 3
PLY
expect 0 '' plate.off wanted.off --background wanted.ply
grep -q 'Faces expected beforehand' .out || fail "the number of faces is not predicted"
[ "$(faces wanted.off)" -gt 40 ] || fail "--background asked for nothing"
expect 0 '' plate.off coarse.off --background wanted.ply --min-size 1 --quiet
[ "$(faces coarse.off)" -le 16 ] || fail "--min-size is not respected"
expect 0 '' plate.off both.off --background wanted.ply --size 0.2 --quiet
[ "$(faces both.off)" -ge 400 ] || fail "the smaller size does not count"
awk 'NR == 2 { print; next } NR > 2 && NF == 3 { print $1, $2, 0.2 * $1 * $1; next } { print }' \
  plate.off >bent.off
expect 0 '' bent.off bent_12.off --curvature 12 --max-size 1 --gradation 0.3 --quiet
expect 0 '' bent.off bent_48.off --curvature 48 --max-size 1 --gradation 0.3 --quiet
[ "$((2 * $(faces bent_48.off)))" -gt "$((3 * $(faces bent_12.off)))" ] || fail "--curvature has no effect"
expect 0 '' bent.off chord.off --chord-error 0.01 --max-size 1 --quiet
[ "$(faces chord.off)" -gt 32 ] || fail "--chord-error has no effect"
expect 0 '' bent.off within.off --size 1 --max-distance 0.01 --report report.json
grep -q '"faces_too_far": \[\]' report.json || fail "faces are farther than --max-distance"
[ "$(faces within.off)" -gt 32 ] || fail "--max-distance has no effect"
# chord errors hold on a smooth surface as well: its ears bend more than the facets show
expect 0 '' "$meshes/spot.off" ears.off --chord-error 0.01 --smooth-reference --quick --quiet --report ears.json
awk -F'[:,]' '/"after"/ { is_after = 1 } is_after && /mesh_to_reference|reference_to_mesh/ { n++; if($2 > 0.011) far++ }
  END { exit !(n == 2 && !far) }' ears.json || fail "--chord-error does not hold with --smooth-reference"
grep -q '6 creases of 12 edges.* degrees at (' ears.json || fail "creases that are not kept are not told"
expect 0 '' bent.off across.off --proximity 3 --max-size 0.7 --quiet
# only a region, or all but the border
centres() { awk 'NR == 2 { n = $1 } NR > 2 && NR <= n + 2 { x[NR - 3] = $1 }
  NF == 5 { print (x[$2] + x[$3] + x[$4] + x[$5]) / 4 }' "$1"; }
expect 3 'larger than asked' plate.off part.off --size 0.5 --region 'x < 2'
[ "$(centres part.off | awk '$1 > 2' | wc -l)" -eq 8 ] || fail "--region changed faces outside"
[ "$(centres part.off | awk '$1 < 2' | wc -l)" -gt 16 ] || fail "--region changed nothing inside"
expect 1 'no face' plate.off part.off --size 0.5 --region 'x < -2'
grid 12 >twelve.off
expect 0 '' twelve.off kept.off --size 3 --keep-border --quiet
awk 'NF == 3 && ($1 == 0 || $1 == 12 || $2 == 0 || $2 == 12)' twelve.off | sort >border_before
awk 'NR > 2 && NF == 3 && ($1 == 0 || $1 == 12 || $2 == 0 || $2 == 12)' kept.off | sort >border_after
cmp border_before border_after || fail "--keep-border did not keep the border"
[ "$(faces kept.off)" -lt 110 ] || fail "--keep-border kept the inside, too"
expect 0 '' twelve.off near.off --size 1.06 --aim nearest --quiet
expect 0 '' twelve.off below.off --size 1.06 --no-symmetry --quiet
[ "$(faces near.off)" -lt "$(faces below.off)" ] || fail "--aim nearest made no fewer faces"
expect 0 '' twelve.off quick.off --size 2.3 --quick --quiet
expect 0 '' twelve.off full.off --size 2.3 --quiet
[ "$(faces full.off)" -le "$(faces quick.off)" ] || fail "--quick made fewer faces"
# patches, marked edges and fixed vertices are kept, and read again
grid_ply() { # grid N: with two halves as patches, the middle of one marked, one vertex fixed
  awk -v n="$1" 'BEGIN {
    print "ply\nformat ascii 1.0\nelement vertex " (n+1)*(n+1) "\nproperty double x\nproperty double y"
    print "property double z\nproperty uchar fixed\nelement face " n*n
    print "property list uchar int vertex_indices\nproperty int patch\nproperty double eta"
    print "element edge " n "\nproperty int vertex1\nproperty int vertex2\nend_header"
    for(j = 0; j <= n; ++j) for(i = 0; i <= n; ++i) print i, j, 0, (i == 1 && j == 1)
    for(j = 0; j < n; ++j) for(i = 0; i < n; ++i) {
      v = j*(n+1)+i; print 4, v, v+1, v+n+2, v+n+1, (i < n/2 ? 3 : 7), 1/(1+i*i+j*j) }
    for(i = 0; i < n; ++i) print n/4*(n+1)+i, n/4*(n+1)+i+1 }'
}
grid_ply 8 >sets.ply
expect 0 '' sets.ply sets_out.ply --size 1.9 --quiet
expect 0 '' sets_out.ply sets_out.obj --size 0.7 --report report.json --quiet
grep -q '"patches": 4' report.json || fail "patches and marked edges do not part the faces"
[ "$(grep -c '^g patch_[37]$' sets_out.obj)" -ge 2 ] || fail "patches were not kept"
grep -q '^v 1 1 0$' sets_out.obj || fail "a fixed vertex was not kept"
awk '/^v / { x[++n] = $2; y[n] = $3 } /^l / { d = x[$3] - x[$2]; sum += d < 0 ? -d : d; off += y[$2] != 2 || y[$3] != 2 }
  END { exit !(off == 0 && sum > 7.999 && sum < 8.001) }' sets_out.obj ||
  fail "marked edges were not kept"
awk '/^v / { x[++n] = $2 } /^g / { left = $2 == "patch_3" }
  /^f / { for(i = 2; i <= 5; ++i) if(left ? x[$i] > 4 : x[$i] < 4) exit 1 }' sets_out.obj ||
  fail "the patches' border moved"
expect 0 '' sets.ply free.obj --size 1.9 --ignore-sets --quiet
grep -q '^[gl] ' free.obj && fail "--ignore-sets kept something"
sed 's/^\(element edge\) 8$/\1 9/; $a 0 80' sets.ply >stray.ply
expect 0 '1 of the 9 marked edges' stray.ply out.ply --size 2
expect 0 'kept: 2 patches, 8 marked edges, 1 fixed vertex;' sets.ply out.ply --size 2
# other numbers at vertices are carried over
sed 's/^property uchar fixed$/property double heat/; s/^\([0-9]* [0-9]* 0\) [01]$/\1 \1/' sets.ply |
  awk 'NF == 6 && $3 == 0 && $6 == 0 { print $1, $2, $3, 100 + 3 * $1 - 2 * $2; next } { print }' >heat.ply
expect 0 '' heat.ply heat_out.ply --size 0.8 --quiet
awk '/^property double/ && !face { n++; if($3 == "heat") at = n } /^element face/ { face = 1 }
  /^end_header/ { data = 1; next } data && at && NF == n { k++; d = $at - (100 + 3 * $1 - 2 * $2); if(d * d > 1e-18) off++ }
  END { exit !(at > 0 && k > 100 && off == 0) }' heat_out.ply || fail "a field was not carried over"
# and at faces, from the one that was there: column i, row j of the grid
awk '/^element vertex/ { nv = $3 } /^element face/ { nf = $3; face = 1 } /^element edge/ { face = 0 }
  /^property (double|int|float|uchar)/ && face { ++m; if($3 == "eta") at = m }
  /^end_header/ { data = 1; next } !data { next }
  ++line <= nv { x[line - 1] = $1; y[line - 1] = $2; next }
  line <= nv + nf { cx = (x[$2] + x[$3] + x[$4] + x[$5]) / 4; cy = (y[$2] + y[$3] + y[$4] + y[$5]) / 4
    ++k; e = 1e-9; for(i = int(cx - e); i <= int(cx + e); ++i) for(j = int(cy - e); j <= int(cy + e); ++j) {
      d = $(5 + at) - 1 / (1 + i*i + j*j); if(d * d < 1e-9) { ++good; i = j = 99 } } }
  END { exit !(at > 0 && k > 60 && good == k) }' heat_out.ply || fail "a field of faces was not carried over"
# but not what is for the eye
sed 's/^property uchar fixed$/property uchar s\nproperty float t/; s/^\([0-9]* [0-9]* 0\) [01]$/\1 0.5 0.5/' \
  sets.ply >look.ply
expect 0 'texture coordinates are left out: s, t$' look.ply look_out.ply --size 0.8
grep -qE '^property double [st]$' look_out.ply && fail "texture coordinates were carried over"
# a fold that is marked or parts patches is a crease
roof() { # roof MARKED PATCHES: two planes that turn by 30 degrees at x = 4
  awk -v marked="$1" -v patches="$2" 'BEGIN {
    for(j = 0; j <= 4; ++j) for(i = 0; i <= 8; ++i) print "v", i, j, (i < 4 ? i : 8 - i) * 0.2679491924
    for(i = 0; i < 8; ++i) { if(patches && i % 4 == 0) print "g side_" i / 4
      for(j = 0; j < 4; ++j) { v = 9*j+i+1; print "f", v, v+1, v+10, v+9 } }
    for(j = 0; j < 4 && marked; ++j) print "l", 9*j+5, 9*j+14 }'
}
roof 0 0 >plain.obj
roof 1 0 >marked.obj
roof 0 1 >parted.obj
for input in plain marked parted; do
  expect 0 '' $input.obj $input.off --chord-error 0.004 --max-size 1 --quiet
done
for input in marked parted; do
  [ "$(faces $input.off)" -le 40 ] || fail "--chord-error resolves a fold that is kept: $input"
  [ "$(faces $input.off)" -lt "$(faces plain.off)" ] || fail "--chord-error does not see a fold"
done
# sizes from error indicators
expect 0 '' sets.ply error.off --error eta --error-reduction 0.2 --ignore-sets --quiet
expect 0 '' sets.ply error_faces.off --error eta --error-faces 400 --ignore-sets --quiet
[ "$(faces error.off)" -gt 64 ] || fail "--error-reduction refined nothing"
[ "$(faces error_faces.off)" -gt 320 ] && [ "$(faces error_faces.off)" -lt 480 ] ||
  fail "--error-faces 400 gave $(faces error_faces.off) faces"
expect 1 'no property "theta"' sets.ply out.off --error theta --error-target 1 --quiet
expect 2 'needs one of' sets.ply out.off --error eta
expect 2 'needs one of' sets.ply out.off --error eta --error-faces 9 --error-target 1
expect 2 'error' sets.ply out.off --size 1 --error-faces 9
# a size that grows too fast is said
expect 0 '' plate.off steep.off --size-function '0.1 + abs(hypot(x, y) - 3)' --report report.json
grep -q 'Note: the size grows' .out || fail "a steep size is not told"
grep -q '"is_too_steep": true' report.json || fail "report.json does not tell of a steep size"
cp plate.off in_place.off
expect 0 '' in_place.off in_place.off --size 0.5 --quiet
[ "$(head -n 2 in_place.off | tail -n 1)" = "$(head -n 2 plate.off | tail -n 1)" ] &&
  fail "in_place.off was not adapted"
[ "$sum" = "$(md5sum <plate.off)" ] || fail "the input was changed"
expect 0 '' --help
for option in $("$program" --help | grep -oE '^ +(-h,)?--[a-z-]+' | grep -oE -- '--[a-z-]+'); do
  case $option in --version) continue ;; esac
  grep -q -e "\`[^\`]*$option\b[^\`]*\`" "$manual" || fail "the manual does not tell of $option"
done
expect 0 '' --version

# a valid mesh, sizes not met
rm -f out.off
expect 3 'not all' plate.off out.off --size 0.01 --schedule paper --max-iterations 1 \
  --report report.json --quiet
wrote out.off
grep -q '"status": "sizes_not_met"' report.json || fail "report.json does not say sizes_not_met"
rm -f out.* again.* report.json picture.svg

# refused meshes
printf '%b' "OFF\n5 2 0\n${square}2 0 0\n4 0 1 2 3\n3 1 4 2\n" >triangle.off
refuse 'face 0 has 3 vertices' "OFF\n4 2 0\n${square}3 0 1 2\n3 0 2 3\n"
refuse 'shared by 3 faces' "OFF\n8 3 0\n${square}1 0 1\n1 1 1\n2 0 0\n2 1 0\n4 0 1 2 3\n4 1 6 7 2\n4 1 4 5 2\n"
refuse 'share no edge' "OFF\n7 2 0\n${square}2 1 0\n2 2 0\n1 2 0\n4 0 1 2 3\n4 2 4 5 6\n"
refuse 'one-sided' "OFF\n6 3 0\n1 0 0\n1 0.5 1\n-1 1 0\n-1 1 1\n-1 -1 0\n-1 -1 1\n4 0 1 3 2\n4 2 3 5 4\n4 4 5 0 1\n"
refuse 'degenerate' "OFF\n4 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 0\n4 0 1 2 3\n"
refuse 'same place' "OFF\n4 1 0\n0 0 0\n1 0 0\n1 0 0\n0 1 0\n4 0 1 2 3\n"
refuse 'vertex 2 .*not finite' "OFF\n4 1 0\n0 0 0\n1 0 0\n1 nan 0\n0 1 0\n4 0 1 2 3\n"
refuse 'vertex 2 .*not finite' "OFF\n4 1 0\n0 0 0\n1 0 0\n1 -inf 0\n0 1 0\n4 0 1 2 3\n"
refuse 'no vertices' "OFF\n0 0 0\n"
refuse 'empty' ''
refuse 'truncated' "OFF\n4 2 0\n${square}4 0 1 2 3\n"
refuse 'truncated' "OFF\n4 1 0\n0 0 0\n1 0 0\n"
refuse 'truncated' "OFF\n4 1 0\n${square}4 0 1 2\n"
refuse 'vertex number' "OFF\n4 1 0\n${square}4 0 1 2 4\n"
refuse 'instead of OFF' 'once upon a time\n'
expect 1 'no such file' missing.off out.off --size 1
mkdir folder.off
expect 1 'regular file' folder.off out.off --size 1
expect 1 'must end in' plate.stl out.off --size 1
if [ "$(id -u)" -ne 0 ]; then
  grid 1 >secret.off && chmod 000 secret.off
  expect 1 'cannot be opened' secret.off out.off --size 1
  rm -f secret.off
fi
expect 1 'missing_reference.off' plate.off out.off --size 1 --reference missing_reference.off

# refused sizes
for size in nan NaN inf -inf 0 -1 1e999; do
  expect 1 'not a positive finite' plate.off out.off --size "$size"
done
for size in abc 1x '' '1 2'; do
  expect 2 'not a number' plate.off out.off --size "$size"
done
for expression in 'x - x' '-1' 'x - 2' 'sqrt(-1 - x)' '1 / (x - x)' '0 / (x - x)' 'ln(x)'; do
  expect 1 'size' plate.off out.off --size-function "$expression"
  refuse_with_report sizes_refused invalid_size 'size' plate.off out.off --size-function "$expression"
  [ "$(tr -d ' \n' <.report | grep -c '"place":\[[-0-9.,]*\]')" -eq 1 ] || fail "no place is reported"
done
refuse_with_report input_refused unreadable_file 'no such file' missing.off out.off --size 1
refuse_with_report input_refused not_all_quads 'has 3 vertices' triangle.off out.off --size 1
grep -q '"entity": 1' .report || fail "the triangle is not named"
refuse_with_report sizes_refused invalid_size 'finite' plate.off out.off --size -1
refuse_with_report sizes_refused invalid_size 'limit' plate.off out.off --size 1e-6
refuse_with_report input_refused unreadable_file 'no such file' plate.off out.off --background missing.ply
refuse_with_report sizes_refused invalid_size 'size' plate.off out.off --size-function 'x - 2' --gradation 0.2
refuse_with_report input_refused invalid_parameter 'no face' plate.off out.off --size 1 --region 'x < -2'
expect 1 'nor is there a report' plate.off out.off --size -1 --report no/such/folder/report.json

# far too many faces: said at once
for size in 1e-6 1e-160 1e-300; do
  expect 1 'more than the limit' plate.off out.off --size "$size"
done
expect 1 'more than the limit' plate.off out.off --size-function 'x < 2 ? 1e-200 : 1'

# refused backgrounds
expect 1 'no such file' plate.off out.off --background missing.ply
expect 1 'must end in .ply' plate.off out.off --background plate.off
sed 's/float size/float length/' wanted.ply >bad.ply
expect 1 'no property "size"' plate.off out.off --background bad.ply
sed 's/^4 0 0 1$/4 0 0 -1/' wanted.ply >bad.ply
expect 1 'size at vertex 1' plate.off out.off --background bad.ply
head -n 12 wanted.ply >bad.ply
expect 1 'truncated' plate.off out.off --background bad.ply

# outputs that cannot be written: known before the work, and then none is
expect 1 'cannot be written' plate.off no/such/folder/out.off --size 1
expect 1 'cannot be written' plate.off folder.off --size 1
expect 1 'cannot be written' plate.off out.off --size 1 --report no/such/folder/report.json
expect 1 'cannot be written' plate.off out.off --size 1 --picture no/such/folder/picture.svg

# wrong usage
expect 2 'INPUT'
expect 2 'OUTPUT' plate.off --size 1
expect 2 'size' plate.off out.off
expect 2 'size' plate.off out.off --size 1 --size-function x
expect 2 'bogus' plate.off out.off --size 1 --bogus
expect 2 'not expected' plate.off out.off more.off --size 1
expect 2 'must end in' plate.off out.stl --size 1
expect 2 'must end in' plate.off out.off --size 1 --picture picture.gif
expect 2 'twice' plate.off out.off --size 1 --report out.off
expect 2 'twice' plate.off out.off --size 1 --report plate.off
expect 2 'twice' plate.off out.off --size 1 --report ./plate.off
expect 2 'twice' plate.off out.off --size 1 --report "$PWD/out.off"
ln -s plate.off link.off
expect 2 'twice' plate.off out.off --size 1 --report link.off
rm link.off
for option in --background --reference --report --picture; do
  expect 2 'empty' plate.off out.off --size 1 $option ""
done
expect 2 'empty' "" out.off --size 1
expect 2 'schedule' plate.off out.off --size 1 --schedule fast
expect 2 'feature-angle' plate.off out.off --size 1 --feature-angle -3
expect 2 'feature-angle' plate.off out.off --size 1 --feature-angle wide
for angle in 0 181 nan; do
  expect 2 'feature-angle' plate.off out.off --size 1 --feature-angle "$angle"
done
expect 2 'max-iterations' plate.off out.off --size 1 --max-iterations 0
for number in 0 -1 nan inf many; do
  for option in --curvature --chord-error --proximity --min-size --max-size --max-distance; do
    expect 2 "^quad_adapt: $option: $number is not a finite number" plate.off out.off --size 1 "$option" "$number"
  done
done
expect 2 'curvature' plate.off out.off --curvature 2
expect 2 'excludes' plate.off out.off --curvature 12 --chord-error 0.1
expect 2 'aim' plate.off out.off --size 1 --aim low
expect 2 'aim' plate.off out.off --size 1 --aim nearest --schedule paper
expect 2 'larger than' plate.off out.off --size 1 --min-size 2 --max-size 1
expect 2 'twice' plate.off wanted.ply --background wanted.ply
expect 2 'size' plate.off out.off --max-size 1
for slope in -0.1 nan steep; do
  expect 2 'gradation' plate.off out.off --size 1 --gradation "$slope"
done
expect 1 'size' plate.off out.off --size-function 'x - 2' --gradation 0.2
for expression in 'x +' 'q' '1, 2' '(x' '' 'sin(x, y)'; do
  expect 2 'size-function' plate.off out.off --size-function "$expression"
done
for expression in 'x <' 'w > 0' 'x = 1'; do
  expect 2 'region' plate.off out.off --size 1 --region "$expression"
done
for expression in 'x = 3' 'y += 1' 'x == 1 ? 1 : x = 2'; do
  expect 2 '== compares' plate.off out.off --size-function "$expression"
done

# interrupted: by its own code, nothing written.  Job control, or the child would ignore Ctrl-C.
grid 40 >large.off
before=$(listing)
set -m
"$program" large.off out.off --size 0.05 --quiet >.out 2>.err &
child=$!
sleep 1
kill -INT "$child"
wait "$child"
status=$?
set +m
checks=$((checks + 1))
[ "$status" -eq 130 ] || fail "exit code $status instead of 130 after an interrupt"
grep -q 'nothing was written' .err || fail "an interrupt is not told"
[ "$before" = "$(listing)" ] || fail "something was written in spite of an interrupt"

printf '%d checks, %d failures\n' "$checks" "$failures"
[ "$failures" -eq 0 ]
