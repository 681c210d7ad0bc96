#!/usr/bin/env bash
# Two rule sets on a suite of models: the table, conditions for scripts, and faults of the input.
. "$(dirname "$0")/support.sh"

expect 0 "$af2" compare tri/classic tri/even -o page.html; cp out table
grep -q '^sj_mean .* better$' out || fail "the table does not say what is better"
grep -q '^finished meshes ' out || fail "the table lacks finished meshes"
grep -q '^time ' out && fail "times are compared without being asked for"
[ "$(grep -c '<svg' page.html)" -gt 40 ] || fail "the page lacks pictures"
expect 0 taskset -c 0 "$af2" compare tri/classic tri/even; same out table
expect 0 "$af2" compare quad/rows quad/rows --format json
python3 -c 'import json
for row in json.load(open("out"))["measures"]:
    assert row.get("difference", 0) == 0 and row.get("verdict") in (None, "no difference"), row' 2>err ||
  fail "a rule set differs from itself"

expect 0 "$af2" compare quad/classic quad/rows --elements quad --format json
python3 -c 'import json
for model in json.load(open("out"))["models"]:
    for finished in model["finished"].values():
        assert finished["quad_share"] > 0.97, model["model"]
        assert finished["inverted"] == 0, model["model"]' 2>err || fail "--elements quad leaves triangles"
expect 2 "$af2" compare tri/classic quad/rows --elements quad; told "the rules 'tri/classic' make no quadrilaterals"

# Conditions.
expect 0 "$af2" compare tri/classic tri/even --fail-if 'sj_mean < -0.02' --fail-if 'failed > 0'
expect 1 "$af2" compare tri/even tri/classic --fail-if 'sj_mean < -0.02'; told 'holds: finished sj_mean -0.0'
expect 1 "$af2" compare tri/even tri/classic --fail-if worse; told 'finished sj_min'
expect 1 "$af2" compare tri/even tri/classic --fail-if 'raw.length_spread worse'; told 'raw length_spread'
expect 2 "$af2" compare tri/even tri/classic --fail-if 'sj < 0'; told "'sj' is not a measure, which are failed"
expect 2 "$af2" compare tri/even tri/classic --fail-if 'time worse'; told 'needs --time'
expect 2 "$af2" compare tri/even tri/classic --fail-if 'sj_min << 0'; told 'MEASURE < NUMBER'

# A rule set that fills nothing.
cat >none.af2 <<'RULES'
af2 1;
ruleset "none" { elements tri; match 0.1; }
rule "close" quality 1 {
  front a -> b -> c -> a;
  at    c (0.5, 0.866);
  zone  a, b, c;
  tri   a b c;
}
RULES
expect 0 "$af2" compare tri/even none.af2 --strict-rules
grep -q '^sj_min  *0 .* -$' out || fail "without meshes, there should be no value"
grep -q '^failed .* worse$' out || fail "failed models do not count"
grep -q '^B failed on 133 finished meshes: ' out || grep -q '^B failed on 131 finished meshes: ' out || fail "failed models are not named"
expect 1 "$af2" compare tri/even none.af2 --fail-if 'stuck worse'; told 'finished stuck'

# A suite of one's own.
mkdir suite empty
cp "$models/plate.poly" suite/plate.poly
for i in 1 2 3 4 5; do sed "s/^3 10 6/3 1$i 6/" "$models/plate.poly" >suite/p$i.poly; done
echo '{"size": 1, "models": {"plate.poly": 0.5}}' >suite/suite.json
expect 0 "$af2" compare tri/classic tri/even --suite suite --format json; cp out suite.json
[ "$(json suite.json models 5 model)" = "plate.poly, size 0.5" ] || fail "the size of a model"
[ "$(json suite.json models 0 model)" = "p1.poly, size 1" ] || fail "the size of all models"
rm suite/suite.json
expect 0 "$af2" compare tri/classic tri/even --suite suite --time
grep -q '^time ' out || fail "--time does not compare times"
echo '{"models": {"plato.poly": 0.5}}' >suite/suite.json
expect 1 "$af2" compare tri/classic tri/even --suite suite; told "there is no model 'plato.poly'"
echo '{"size": 0}' >suite/suite.json
expect 1 "$af2" compare tri/classic tri/even --suite suite; told 'suite.json'
echo '{"size": 1}' >suite/suite.json
echo 'no domain' >suite/bad.poly
expect 0 "$af2" compare tri/classic tri/even --suite suite
grep -q '^A failed on 1 raw meshes: bad.poly, size 1 (' out || fail "an unreadable model is not named"

# Bad input.
expect 1 "$af2" compare tri/classic tri/even --suite empty; told 'has no model'
expect 1 "$af2" compare tri/classic tri/even --suite nowhere; told 'no such folder'
expect 1 "$af2" compare tri/classic tri/evn; told "there is no rule file 'tri/evn'"
echo 'af2 1; rule' >broken.af2
expect 1 "$af2" compare tri/classic broken.af2; told 'broken.af2'
expect 2 "$af2" compare tri/classic; told 'B'
expect 2 "$af2" compare tri/classic tri/even -o page.txt; told '.html'
expect 2 "$af2" compare tri/classic tri/even -o nowhere/page.html; told 'nowhere'
expect 2 "$af2" compare tri/classic tri/even --suite suite --long; told '--long'

# Ctrl-C.
expect 4 timeout --preserve-status -s INT 1 "$af2" compare quad/classic quad/rows --long -o stopped.html
told 'stopped before all models were meshed'
[ -e stopped.html ] && fail "a page of half a comparison was written"
finish
