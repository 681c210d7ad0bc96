#!/usr/bin/env bash
# Measures of mesh files: the same from every format, and reasons for files that cannot be measured.
. "$(dirname "$0")/support.sh"
plate=$models/plate.poly

expect 0 "$af2" mesh "$plate" --size 0.5 -r quad/rows --edges -o p.vtu -o p.vtk -o p.msh --quiet
expect 0 "$af2" mesh "$plate" --size 0.5 -r quad/rows -o p.obj -o p.ply -o p.stl --report r.json --quiet
expect 0 "$af2" quality p.vtu --format json; cp out vtu.json
[ "$(json vtu.json quads)" = "$(json r.json quads)" ] || fail "counts differ from those of the report"
[ "$(json vtu.json quality min)" = "$(json r.json quality min)" ] || fail "the lowest quality differs"
[ "$(json vtu.json length_unit)" = "target size" ] || fail "the sizes in the file are not used"
for file in p.vtk p.msh p.obj p.ply; do
  expect 0 "$af2" quality $file --size 0.5 --format json; cp out other.json
  python3 -c 'import json
one, other = json.load(open("vtu.json")), json.load(open("other.json"))
for key in "quads triangles scaled_jacobian angles aspect irregular spokes shape".split():
    assert one[key] == other[key], key' 2>err || fail "measures differ in $file"
done
expect 0 "$af2" quality p.stl
grep -q '(--feature-angle)' out || fail "there is no note on faces"
grep -q 'edge length / median length' out || fail "there is no note on sizes"
expect 0 "$af2" quality p.vtu; cp out first
expect 0 "$af2" quality p.vtu; same out first
grep -q '^scaled Jacobian, quads ' out || fail "the table lacks a row"
grep -q 'Euler number 0' out || fail "a plate with a hole has Euler number 0"

for picture in p.png p.svg p.html; do
  expect 0 "$af2" quality p.vtu --picture $picture
  [ -s $picture ] || fail "$picture is not there"
done
expect 0 "$af2" mesh "$models/cylinder.step" --size 5 --order 2 -o c.msh --quiet
if [ -e c.msh ]; then
  expect 0 "$af2" quality c.msh; grep -q 'only their corners are read' out || fail "second order"
  expect 1 "$af2" quality c.msh --picture c.svg; told 'planar meshes only'
  [ -e c.svg ] && fail "a picture that cannot be drawn was left"
fi

# Bad input.
head -c 3000 p.vtu >cut.vtu
expect 1 "$af2" quality cut.vtu; told 'truncated'; says_one_line
expect 1 "$af2" quality "$plate"; told 'give a file in one of .vtu'
expect 1 "$af2" quality nothing.vtu; told 'check that it exists'
expect 1 "$af2" quality .; told 'is not a mesh file'
echo 'v 0 0 0' >empty.obj
expect 1 "$af2" quality empty.obj; told 'contains no elements'
expect 2 "$af2" quality p.vtu --picture p.jpg; told '.png, .svg or .html'
expect 2 "$af2" quality p.vtu --picture nowhere/p.png; told 'nowhere'
expect 2 "$af2" quality p.vtu --size 0; told '--size'
expect 2 "$af2" quality p.vtu --feature-angle 270; told 'at most 180'
expect 2 "$af2" quality p.vtu --feature-angle x; told '--feature-angle'
expect 2 "$af2" quality; told 'MESH'
finish
