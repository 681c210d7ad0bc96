#!/usr/bin/env bash
# Points and curves of a file that the mesh keeps inside faces.
. "$(dirname "$0")/support.sh"

cat >square.poly <<'END'
4 2 0 0
1 0 0
2 10 0
3 10 6
4 0 6
4 0
1 1 2
2 2 3
3 3 4
4 4 1
0
END
echo '{"points": [[8, 5]], "curves": [[[2, 2], [5, 2], [5, 4]], [[0, 3], [1, 3]]]}' >inside.json
expect 0 "$af2" mesh square.poly --size 0.6 --points inside.json --edges -o planar.msh
grep -qa '"edge 7"' planar.msh || fail "no edge 7 in the mesh"
# Layers along a curve inside.
expect 0 "$af2" mesh square.poly --size 0.6 --points inside.json --layers 5,6=0.03,1.3,4 -o layers.png
grep -q 'everywhere as asked' out || fail "no layers along the curve"

echo '{"curves": [[[8, 5], [12, 5]]]}' >far.json
expect 1 "$af2" mesh square.poly --size 0.6 --points far.json
[ "$(wc -l <err)" -le 2 ] || fail "more than one fault"
echo '{"points": [[12, 5]]}' >out.json
expect 1 "$af2" mesh square.poly --size 0.6 --points out.json
told "point 1 inside the domain"

if "$af2" mesh --help | grep -q STEP; then
  echo '{"curves": [[[0, 2, 2], [0, 8, 5], [0, 8, 8]]]}' >cad.json
  expect 0 "$af2" mesh "$models/brickhole.step" --size 1 --points cad.json --edge-size 25=0.2 -o a.vtu
  grep -q 'closed' out || fail "the mesh is not closed"
  echo '{"curves": [[[0, 2, 2], [5, 0, 5]]]}' >across.json
  expect 1 "$af2" mesh "$models/brickhole.step" --size 1 --points across.json
  told "curve 1 inside faces is not inside one face"
  says_one_line
fi
finish
