#!/usr/bin/env bash
# The program reports what the rules did not do, and does not run rules that are wrong.
. "$(dirname "$0")/support.sh"
die=$models/die.step
plate=$models/plate.poly
rules=$2/rules/tri/classic.af2

# A rule set that accepts nothing: every element is made by closing.
sed 's/accept .*;/accept score < 0;/' "$rules" >never.af2
expect 0 "$af2" mesh "$die" --size 1 -r never.af2 --unchecked --report never.json -o never.vtu --quiet
told 'elements were made without a rule (closing'
told 'face '
[ "$(json never.json without_rule closing)" = "$(json never.json triangles)" ] || fail "not all elements are by closing"
[ "$(json never.json faces 0 without_rule closing)" -gt 0 ] || fail "face 1 does not count its elements"
# A mesh whose fronts had to be closed is optimised like others.
sed '/^test/,$d; /^rule "free triangle {k}"/,/^}/d; /^rule "fill/,/^}/d; /^rule .*vis a vis/,/^}/d' "$rules" >stuck.af2
expect 0 "$af2" mesh "$plate" --size 0.5 -r stuck.af2 --report stuck.json --quiet
[ "$(json stuck.json without_rule closing)" -gt 0 ] || fail "no front got stuck"
python3 - stuck.json <<'PYTHON' || fail "a mesh with closing elements is not optimised"
import json, sys
quality = json.load(open(sys.argv[1]))["quality"]
assert quality["min"] > 0.5, quality
PYTHON
expect 3 "$af2" mesh "$die" --size 1 -r never.af2 --unchecked --strict-rules --report strict.json -o strict.vtu
[ "$(json strict.json status)" = failed ] || fail "--strict-rules made elements"
[ "$(json strict.json faces 0 stuck 0 level)" -ge 1 ] || fail "a strict face does not say where it got stuck"
python3 - strict.json <<'PYTHON' || fail "--strict-rules tried again"
import json, sys
faces = json.load(open(sys.argv[1]))["faces"]
sys.exit(any("closing" in text for face in faces for text in face.get("attempts", [])))
PYTHON
[ ! -e strict.vtu ] || fail "a file without elements was written"

expect 1 "$af2" mesh "$die" --size 1 -r never.af2 --quiet
told 'AF2-D4'

# Rules that fill everything are not affected.
expect 0 "$af2" mesh "$plate" --size 0.5 --report plain.json
expect 0 "$af2" mesh "$plate" --size 0.5 --strict-rules --report same.json
[ "$(json plain.json fingerprint)" = "$(json same.json fingerprint)" ] || fail "--strict-rules changed a mesh"
[ "$(json plain.json without_rule closing)" = 0 ] || fail "elements without a rule on a plate"

# An error that the checks prove ends the run before it begins.
sed 's/zone a, b, m + (1, 0.7) => c, .*;/zone a, b, m + (0.2, 0.2) => c, m + (-0.2, 0.2) => c;/' "$rules" >uncovered.af2
expect 1 "$af2" mesh "$plate" --size 0.5 -r uncovered.af2 -o uncovered.vtu --quiet
told 'AF2-Z1'
told '--unchecked'
[ ! -e uncovered.vtu ] || fail "rules with an error made a file"
expect 3 "$af2" mesh "$plate" --size 0.5 -r uncovered.af2 --unchecked
told "most by 'free triangle 1' ("  # rather than that the model is to blame

# Warnings are counted, and not at all with --quiet.
sed '/^test/,$d; /mirror/d' "$rules" >lonely.af2
expect 0 "$af2" mesh "$plate" --size 0.5 -r lonely.af2
told 'warning'
grep -q 'M1' err && fail "a run repeats warnings in full"
expect 0 "$af2" mesh "$plate" --size 0.5 -r lonely.af2 --quiet
[ ! -s err ] || fail "--quiet prints warnings about rules"

finish
