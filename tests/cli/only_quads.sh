#!/usr/bin/env bash
# Meshes of quadrilaterals only, and what the program says where that is impossible.
. "$(dirname "$0")/support.sh"
die=$models/die.step
plate=$models/plate.poly

for model in "$models/cylinder.step" "$models/brickhole.step" "$die" "$plate"; do
  expect 0 "$af2" mesh "$model" --size 0.5 --elements quad -o quads.obj --report quads.json --quiet
  [ "$(json quads.json triangles)" = 0 ] || fail "triangles in $model"
  [ "$(json quads.json quads)" -gt 100 ] || fail "too few quadrilaterals in $model"
done
expect 0 "$af2" mesh "$models/cylinder.step" --size 0.5 --elements quad --report one.json --quiet -j 1
expect 0 "$af2" mesh "$models/cylinder.step" --size 0.5 --elements quad --report two.json --quiet -j 2
[ "$(json one.json fingerprint)" = "$(json two.json fingerprint)" ] || fail "the mesh depends on the threads"

# A large face is cut into pieces. Each can be filled with quadrilaterals, and those of a grid are grids.
printf '4 2 0 0\n1 0 0\n2 1 0\n3 1 .6\n4 0 .6\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n' >large.poly
expect 0 "$af2" mesh large.poly --size 0.002 --elements quad --report large.json -o large.obj --quiet -j 2
[ "$(json large.json quads)" = 150000 ] || fail "the pieces of a grid are no grids"
expect 0 "$af2" mesh "$plate" --size 0.02 --elements quad --report one.json --quiet -j 1
expect 0 "$af2" mesh "$plate" --size 0.02 --elements quad --report many.json --quiet -j 7
[ "$(json one.json triangles)" = 0 ] || fail "triangles where pieces meet"
[ "$(json one.json fingerprint)" = "$(json many.json fingerprint)" ] || fail "the pieces depend on the threads"

# A boundary that is given and odd.
cat >odd.poly <<'POLY'
5 2 0 0
1 0 0
2 1 0
3 2 0
4 2 2
5 0 2
5 0
1 1 2
2 2 3
3 3 4
4 4 5
5 5 1
0
POLY
expect 3 "$af2" mesh odd.poly --size 1 --keep-boundary --elements quad --report odd.json -o odd.vtu
told 'odd.poly: triangles remain, which --elements quad does not accept: face 1 (1 triangle at (0.999, 1.71, 0); loop 1 of its boundary has 5 edges: divide the one from (2, 0, 0) to (2, 2, 0), which is 2 sizes long)'
[ "$(json odd.json status)" = partial ] || fail "the report says nothing of triangles"
[ "$(json odd.json faces 0 odd_loops 0 edges)" = 5 ] || fail "the report does not name the loop"
[ "$(json odd.json faces 0 odd_loops 0 longest sizes)" = 2.0 ] || fail "the report names no edge to be divided"
[ -s odd.vtu ] || fail "the mesh was not written"

# An odd boundary whose front ends at elements that turn round nowhere: it is advanced without them.
expect 3 "$af2" mesh "$2/tests/cli/models/thin_odd.poly" --size 0.08 --keep-boundary --elements quad -r quad/paving -o thin.vtu --report thin.json
[ "$(json thin.json triangles)" = 1 ] || fail "an odd loop takes more than one triangle"

# An even boundary with a straight corner: one quadrilateral would be flat, so it gets more.
printf '3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n' >corner.poly
expect 0 "$af2" mesh corner.poly --size 2 --elements quad --quiet

# An even boundary, but no room.
sed 's/^3 0 1$/3 0.5 0.0001/' corner.poly >needle.poly
expect 3 "$af2" mesh needle.poly --size 2 --elements quad --quiet
told 'face 1 (2 triangles, one of them at (0.333, 3.33e-05, 0); elements cannot change enough to join them)'

# What the front did beside adding elements is told.
expect 0 "$af2" mesh "$plate" --size 0.05 --elements quad -r quad/paving --report acts.json --quiet
grep -q '"rows": [1-9]' acts.json || fail "the report lacks the rows of the front"

# How long to look for better meshes.
for level in fast good best; do
  expect 0 "$af2" mesh "$plate" --size 0.1 --elements quad --quality $level -o $level.vtu --quiet
  expect 0 "$af2" quality $level.vtu --format json
  cp out $level.json
done
python3 - fast.json good.json best.json <<'PYTHON' || fail "more time does not make meshes more regular"
import json, sys
def share(name):
    inside = json.load(open(name))["irregular"]["inside"]
    return inside["irregular"] / inside["vertices"]
fast, good, best = map(share, sys.argv[1:])
print(fast, good, best)
assert best <= good < fast
PYTHON

expect 2 "$af2" mesh "$plate" --size 0.5 --elements quad -r tri/even; told 'make no quadrilaterals'
expect 2 "$af2" mesh "$plate" --size 0.5 --elements quad --no-optimize; told 'leave out --no-optimize'
expect 2 "$af2" mesh "$plate" --size 0.5 --elements hexagon; told '--elements'
finish
