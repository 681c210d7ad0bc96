#!/usr/bin/env bash
# Meshes across edges that only the CAD has: --merge.
. "$(dirname "$0")/support.sh"
die=$models/die.brep

# What is merged is told, listed beforehand, and drawn.
expect 0 "$af2" mesh "$die" -s 0.6 --merge -j 1 -o one.obj -o one.vtu --report merged.json
grep -Eq "merged [0-9]+ faces into [0-9]+, without [0-9]+ edges and [0-9]+ vertices; at most 0\.[0-9]+ from the model" out ||
  fail "mesh does not say what it merged"
grep -q "closed" out || fail "the mesh is not closed"
[ "$(json merged.json status)" = complete ] || fail "status with --merge"
[ "$(json merged.json merging angle)" = 10.0 ] || fail "the usual angle"
expect 0 "$af2" mesh "$die" -s 0.6 --report plain.json
grep -q '"merging"' plain.json && fail "a mesh without --merge has merged faces"
expect 0 "$af2" mesh "$die" -s 0.6 --merge=10deg -j 2 -o two.obj
same one.obj two.obj
expect 0 "$af2" inspect "$die" --brief --merge -s 0.6 --picture groups.svg
grep -q "edges that the mesh crosses" out || fail "inspect does not list what is merged"
[ -s groups.svg ] || fail "inspect --merge draws nothing"

# Original faces stay.
grep -q "^g face_3" one.obj || fail "the faces of the model are no groups"
[ "$(grep -c '^g ' one.obj)" = "$(grep '^g ' one.obj | sort -u | wc -l)" ] || fail "a group comes twice"

# With other options.
expect 0 "$af2" mesh "$die" -s 0.6 --merge --order 2
expect 0 "$af2" mesh "$die" -s 0.8 --merge --elements quad
grep -q " 0 triangles" out || fail "--merge leaves triangles"
expect 0 "$af2" mesh "$die" -s 0.8 --merge --chord 0.05
expect 0 "$af2" mesh "$2/tests/cli/models/two_boxes.brep" -s 0.5 --merge --imprint
expect 0 "$af2" mesh "$die" -s 0.6 --merge 3 --merge-narrow 0 --merge-keep 5,7-9

# Bad usage.
expect 2 "$af2" mesh "$models/plate.poly" -s 1 --merge; told "--merge is for"
expect 2 "$af2" mesh "$die" -s 1 --merge ninety; told "--merge 'ninety'"
expect 2 "$af2" mesh "$die" -s 1 --merge 90; told "up to 60 degrees"
expect 2 "$af2" mesh "$die" -s 1 --merge --merge-narrow 0.7; told "--merge-narrow '0.7'"
expect 2 "$af2" mesh "$die" -s 1 --merge-narrow 0.1; told "--merge-narrow needs --merge"
expect 2 "$af2" mesh "$die" -s 1 --merge-keep 1; told "--merge-keep needs --merge"
expect 2 "$af2" mesh "$die" -s 1 --merge --fewest --chord 0.1; told "--merge cannot be combined"
expect 0 "$af2" inspect "$die" --merge --json; grep -q '"merging"' out || fail "JSON lacks what would be merged"
expect 1 "$af2" mesh "$die" -s 1 --merge --merge-keep 999; told "no edge 999"
expect 1 "$af2" mesh "$die" -s 1 --merge --merge-keep inlet; told "'inlet'"

finish
