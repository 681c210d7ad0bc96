#!/usr/bin/env bash
# Layers of quadrilaterals along edges: option, summary, report, faults.
. "$(dirname "$0")/support.sh"

cat >square.poly <<'END'
4 2 0 0
1 0 0
2 10 0
3 10 6
4 0 6
4 1
1 1 2 7
2 2 3 3
3 3 4 3
4 4 1 3
0
END
square() { expect "$1" "$af2" mesh square.poly --size 0.7 "${@:2}"; }

square 0 --layers 1=0.05,1.3,6 --report r.json -o one.vtu -o one.png
grep -q '^layers: 84 elements along 1 edge of faces, everywhere as asked$' out ||
  fail "no line about layers"
[ "$(json r.json faces 0 layers 0 fewest)" = 6 ] || fail "report without layers"
[ "$(json r.json faces 0 layer_elements)" = 84 ] || fail "report without elements of layers"
grep -q 'Name="rule: layer"' one.vtu || fail "elements of layers have no name in the file"
square 0 --layers "boundary 7=0.05,1.3,6" -o named.vtu
same one.vtu named.vtu
square 0 --layers @1=0.4,1.5,4 --report r.json
grep -q 'thinner than asked along 4 of them: edge 2 of face 1 (down to' out ||
  fail "nothing about thinner layers"
[ "$(json r.json faces 0 layers 1 thinner)" -gt 0 ] || fail "report without thinner layers"
square 0 --layers @1=3,1.5,2 --report r.json
grep -q 'fewer than asked along 4 of them: edge' out || fail "nothing about fewer layers"

square 2 --layers 9=0.05,1.3,6
told "there is no edge 9"
square 2 --layers 1@2=0.05,1.3,6
told "there is no face 2"
for wrong in 1 =1,2,3 1=0,1.2,3 1=0.1,0,3 1=0.1,-1,3 1=0.1,1.2,0 1=0.1,1.2,2.5 1=0.1,1.2 1=0.1,1.2,3,4 1=a,b,c 1@=0.1,1,1; do
  square 2 --layers "$wrong"
  told "--layers"
  says_one_line
done
square 1 --layers inlet=0.05,1.3,6
told "'inlet'"
square 1 --layers 1=0.1,3,9
told "high together"
square 3 --layers @1=8,1,1 -o none.vtu
told "no room"
square 2 --layers 1=0.1,1,1 --fewest --chord 0.1
told "--fewest cannot be combined with --layers"

# All of quadrilaterals, also where there is room for fewer layers.
expect 0 "$af2" mesh "$models/plate.poly" --size 1 --layers @1=0.2,1.3,6 --elements quad
grep -q ' 0 triangles' out || fail "layers left triangles"
grep -q 'fewer than asked' out || fail "there was room for all layers"

for threads in 2 3; do
  for model in brickhole die; do
    expect 0 "$af2" mesh "$models/$model.step" --size 0.7 --layers @1-5=0.01,1.3,5 -j 1 -o a.vtu
    expect 0 "$af2" mesh "$models/$model.step" --size 0.7 --layers @1-5=0.01,1.3,5 -j $threads -o b.vtu
    same a.vtu b.vtu
  done
done
finish
