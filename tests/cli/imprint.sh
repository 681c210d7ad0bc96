#!/usr/bin/env bash
# Parts that touch are told of, and share their faces with --imprint.
. "$(dirname "$0")/support.sh"
parts=$2/tests/cli/models
bolt=$models/bolt_on_plate.brep
overlap=$parts/overlapping_boxes.brep

# Without the option.
expect 0 "$af2" mesh "$bolt" -s 1 -o plain.obj --report plain.json
grep -q "1 pair of parts touches, e.g. 'solid 1' and 'solid 2' at (5, 5, 1)" out || fail "mesh does not tell of parts that touch"
[ "$(json plain.json contacts pairs 0 kind)" = touch ] || fail "the report does not tell of parts that touch"
[ "$(json plain.json contacts pairs 0 area | cut -c1-5)" = 3.141 ] || fail "area in common"
expect 0 "$af2" mesh "$models/cylinder.brep" -s 1 --report one.json
json one.json contacts >/dev/null 2>&1 && fail "a model of one part has contacts"
expect 0 "$af2" inspect "$bolt"
grep -q "2 parts; 1 pairs" out || fail "inspect does not list parts that touch"
expect 0 "$af2" inspect "$overlap"
grep -q "overlap     volume 6 " out || fail "inspect does not list parts that overlap"

# With it.
expect 0 "$af2" mesh "$bolt" -s 1 --imprint -j 1 -o one.obj --report imprinted.json
grep -q "imprinted 2 parts with tolerance .*: 1 interface$" out || fail "--imprint does not tell what it did"
[ "$(json imprinted.json status)" = complete ] || fail "status with --imprint"
[ "$(json imprinted.json imprinting interfaces)" = 1 ] || fail "the report does not tell of --imprint"
grep -q '"solid 1|solid 2"' imprinted.json || fail "the interface is no group"
expect 0 "$af2" mesh "$bolt" -s 1 --imprint -j 2 -o two.obj
same one.obj two.obj
expect 0 "$af2" inspect "$bolt" --imprint
grep -q "none touches another one without sharing" out || fail "inspect --imprint does not imprint"
expect 0 "$af2" mesh "$bolt" -s 1 --imprint --imprint-tolerance 1e-3
grep -q "tolerance 0.001" out || fail "--imprint-tolerance did nothing"
expect 0 "$af2" mesh "$bolt" -s 1 --glue

# Overlaps.
expect 1 "$af2" mesh "$overlap" -s 1 --imprint -o refused.obj
told "'solid 1' and 'solid 2' (volume 6)"
told "--overlap first, last or cut"
[ -e refused.obj ] && fail "a refused model was written"
for part in first last cut; do
  expect 0 "$af2" mesh "$overlap" -s 1 --imprint --overlap $part --report $part.json
  [ "$(json $part.json status)" = complete ] || fail "status with --overlap $part"
done
grep -q '"solid 1&solid 2"' cut.json || fail "the overlap is no part of its own"

# Bad usage.
expect 2 "$af2" mesh "$overlap" -s 1 --imprint --overlap both; told "overlap"
expect 2 "$af2" mesh "$bolt" -s 1 --overlap first; told "--overlap needs --imprint"
expect 2 "$af2" mesh "$bolt" -s 1 --imprint-tolerance 1; told "needs --imprint or --glue"
expect 2 "$af2" mesh "$bolt" -s 1 --imprint --glue; told "exclude each other"
expect 2 "$af2" mesh "$bolt" -s 1 --glue --overlap first; told "--overlap needs --imprint"
expect 2 "$af2" mesh "$bolt" -s 1 --imprint --imprint-tolerance -1; told "--imprint-tolerance"
expect 2 "$af2" mesh "$models/plate.poly" -s 1 --imprint; told "STEP, IGES and BREP"
expect 0 "$af2" mesh "$bolt" -s 1 -q -o plain.stl
expect 2 "$af2" mesh plain.stl -s 1 --imprint; told "--imprint is for"
expect 2 "$af2" inspect "$models/plate.poly" --glue; told "--glue is for"
finish
