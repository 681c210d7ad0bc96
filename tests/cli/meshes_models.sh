#!/usr/bin/env bash
# The models of the examples come out complete, in every format, with a report.
. "$(dirname "$0")/support.sh"

for model in brickhole cylinder die; do
  expect 0 "$af2" mesh "$models/$model.step" --size 1 -o $model.vtu --report $model.json
  [ "$(json $model.json status)" = complete ] || fail "status of $model"
  [ "$(json $model.json triangles)" -gt 100 ] || fail "number of triangles of $model"
  [ -s $model.vtu ] || fail "$model.vtu is missing"
done

expect 0 "$af2" mesh "$models/cylinder.brep" -s 1 -o a.vtu -o a.vtk -o a.msh -o a.stl -o a.obj -o a.ply
for format in vtu vtk msh stl obj ply; do
  [ -s a.$format ] || fail "a.$format is missing"
done

expect 0 "$af2" mesh "$models/cylinder.step" --size 1 --faces 1-2 --report some.json
[ "$(json some.json status)" = complete ] || fail "status of some faces"
[ "$(json some.json triangles)" -lt "$(json cylinder.json triangles)" ] || fail "all faces were meshed"

expect 0 "$af2" mesh "$models/cylinder.step" --size 1 --face-size 1=0.25 --report fine.json
[ "$(json fine.json triangles)" -gt "$(json cylinder.json triangles)" ] || fail "--face-size did nothing"

echo '{"points": [{"at": [0, 0, 0], "size": 0.2}], "parts": {"*": 0.9}}' >sizes.json
expect 0 "$af2" mesh "$models/cylinder.step" --size 1 --sizes sizes.json --report near.json
[ "$(json near.json triangles)" -gt "$(json cylinder.json triangles)" ] || fail "--sizes did nothing"
expect 0 "$af2" mesh "$models/cylinder.step" --size 1 --curvature 40 --min-size 0.3 --grading 0.2 --report round.json
[ "$(json round.json triangles)" -gt "$(json cylinder.json triangles)" ] || fail "--curvature did nothing"
echo '{"edges": {"3": []}}' >divided.json
expect 0 "$af2" mesh "$models/brickhole.step" --size 1 --boundary divided.json --report divided_report.json
expect 0 "$af2" mesh "$models/brickhole.step" --size 1 --report plain.json
[ "$(json divided_report.json vertices)" -lt "$(json plain.json vertices)" ] || fail "--boundary did nothing"
expect 0 "$af2" mesh "$models/plate.poly" --size 1 --max-size 0.5 --sizes sizes.json
expect 0 "$af2" mesh "$models/plate.poly" --size 1 --proximity 3 --keep-boundary
expect 0 "$af2" inspect "$models/plate.poly" --size 0.5
grep -q plane out || fail "inspect does not list the faces of a planar domain"
expect 0 "$af2" mesh "$models/plate.poly" --size 1 --edge-size 1=0.1 --face-size 1=0.5
cp "$models/plate.poly" PLATE.POLY
expect 0 "$af2" mesh PLATE.POLY --size 1

for chart in auto mean-normal normal-lines parametric affine developed; do
  expect 0 "$af2" mesh "$models/cylinder.step" --size 1 --chart $chart --report chart.json
  [ $chart = auto ] || [ "$(json chart.json faces 0 chart)" = $chart ] || fail "--chart $chart did nothing"
done

expect 0 "$af2" mesh "$models/cylinder.step" --size 1 --order 2 -o second.vtu -o second.msh --report second.json
[ "$(json second.json order)" = 2 ] || fail "order of the elements"
[ "$(json second.json vertices)" -gt "$(json cylinder.json vertices)" ] || fail "--order did nothing"
[ "$(json second.json groups 0 kind)" = solid ] || [ "$(json second.json groups 0 kind)" = part ] || fail "no groups"

expect 0 "$af2" mesh "$models/brickhole.step" --size 1 -o brick.stl --quiet
expect 0 "$af2" mesh brick.stl --size 2 --feature-angle 30 -o again.vtu --report again.json
[ "$(json again.json status)" = complete ] || fail "an STL file is not meshed"
expect 0 "$af2" inspect brick.stl --size 2
grep -q 'no defects' out || fail "inspect tells of defects of an STL file that are none"
echo '{"edges": {"1": []}}' >single.json
expect 0 "$af2" mesh brick.stl --size 2 --feature-angle 30 --boundary single.json --face-size 2=0.5 --chart normal-lines --report finer.json
[ "$(json finer.json triangles)" -gt "$(json again.json triangles)" ] || fail "--face-size did nothing on an STL file"
expect 0 "$af2" mesh brick.stl --size 2 --faces 1-2 --edge-size 1=0.5 --report some.json
[ "$(json some.json faces 1 id)" = 2 ] || fail "--faces did nothing on an STL file"

printf 'splinecurves2dv2\n2\npoints\n1 1 0\n2 1 1\n3 0 1\n4 0 0\n' >quarter.in2d
printf 'segments\n1 0 3 1 2 3\n1 0 2 3 4\n1 0 2 4 1\n' >>quarter.in2d
expect 0 "$af2" mesh quarter.in2d --size 0.2 --curvature 40 --report quarter.json
[ "$(json quarter.json groups 0 name)" = 'domain 1' ] || fail "the domain of an .in2d file is no group"

printf '4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 1\n1 1 2 3\n2 2 3 3\n3 3 4 0\n4 4 1 0\n0\n' >marked.poly
expect 0 "$af2" mesh marked.poly --size 0.5 -o marked.msh --report marked.json
[ "$(json marked.json groups 0 edges)" = '[1, 2]' ] || fail "the report does not tell of the boundary"
grep -aq '^1 3 "boundary 3"$' marked.msh || fail "the boundary of a .poly file is no physical group"
expect 0 "$af2" inspect marked.poly
grep -Eq '^ +2  3 +$' out || fail "inspect does not list the boundary"
expect 0 "$af2" mesh marked.poly --size 0.5 --edges -o marked.msh
grep -aq '^1 6 "edge 3"$' marked.msh || fail "--edges did nothing for a .poly file"
expect 0 "$af2" mesh "$models/cylinder.step" --size 1 --edges -o edges.msh -o edges.vtu
grep -aq '^1 2 "edge 2"$' edges.msh || fail "--edges did nothing for a STEP file"
expect 2 "$af2" mesh "$models/cylinder.step" --size 1 --edges -o edges.stl
told 'cannot hold the line elements that --edges asks for'

expect 0 "$af2" mesh "$models/cylinder.step" --size 1 --quiet
[ ! -s out ] && [ ! -s err ] || fail "--quiet printed something"

expect 0 "$af2" mesh "$models/cylinder.step" --size 1 --heal --heal-tolerance 1e-4 --report healed.json
grep -q 'healed with tolerance 0.0001' out || fail "--heal does not tell what it did"
[ "$(json healed.json healing tolerance)" = 0.0001 ] || fail "the report does not tell of --heal"
[ "$(json healed.json status)" = complete ] || fail "status after healing"

# OpenCASCADE's repairs crash on a face without a surface; the other faces are meshed nevertheless.
awk '/^Fa$/ && !done { print; getline; print "0  1e-07 0 0"; done = 1; next } { print }' \
  "$models/cylinder.brep" > damaged.brep
expect 3 "$af2" mesh damaged.brep --size 1 --heal --report damaged.json
told 'the face has no surface'
grep -q 'the repairs were left out: when tried, the run crashed' out ||
  fail "a crash of the repairs is not told"
[ "$(json damaged.json triangles)" -gt 100 ] || fail "a crash of the repairs takes all faces down"

expect 0 "$af2" inspect "$models/cylinder.step"
grep -q cylinder out || fail "inspect does not tell of the cylinder"
grep -q 'no defects' out || fail "inspect tells of defects that are none"
expect 0 "$af2" inspect "$models/cylinder.step" --edges
[ "$(grep -c circle out)" -eq 2 ] || fail "inspect --edges does not list the two circles"
grep -Eq 'line .* 1  +\(' out || fail "inspect --edges does not list the seam of face 1"
expect 0 "$af2" inspect "$models/plate.poly" --edges
[ "$(grep -c ' line ' out)" -gt 4 ] || fail "inspect --edges does not list the segments of a planar domain"
expect 0 "$af2" inspect "$models/cylinder.step" --size 100 --picture defects.svg
grep -q 'sliver' out || fail "inspect does not tell of faces that are narrow against the mesh"
[ -s defects.svg ] || fail "there is no picture of the defects"
expect 0 "$af2" inspect "$models/cylinder.brep" --heal --picture healed.png --brief
grep -q 'nothing changed' out || fail "inspect --heal does not tell what it did"
[ -s healed.png ] || fail "there is no picture of the healed model"

finish
