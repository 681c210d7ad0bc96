#!/usr/bin/env bash
# From a run to the reason of one of its steps, and to a test of it.
. "$(dirname "$0")/support.sh"
plate=$models/plate.poly
die=$models/die.step
cp "$2/rules/tri/classic.af2" mine.af2

expect 0 "$af2" mesh "$plate" --size 0.5 -r mine.af2 --trace plate.af2t --report plain.json --quiet
expect 0 "$af2" mesh "$plate" --size 0.5 -r mine.af2 --report untraced.json --quiet
[ "$(json plain.json fingerprint)" = "$(json untraced.json fingerprint)" ] || fail "--trace changed the mesh"
expect 0 "$af2" mesh "$die" --size 1 -j 2 --trace two.af2t --quiet
expect 0 "$af2" mesh "$die" --size 1 -j 1 --trace one.af2t --quiet
expect 0 "$af2" trace diff one.af2t two.af2t
grep -q '68 of 68 faces took the same steps' out || fail "the trace depends on the threads"
expect 0 "$af2" mesh "$die" --size 1 --trace part.af2t --trace-faces 3,5-6 --quiet
expect 1 "$af2" trace diff one.af2t part.af2t
grep -q '3 of 3 faces took the same steps, 65 are in one trace only' out || fail "--trace-faces"

expect 0 "$af2" explain plate.af2t --step 1
grep -q '^face 1, step 1: ' out || fail "explain does not name the step"
grep -q 'applied' out || fail "explain does not name the rule that was applied"
expect 0 "$af2" explain plate.af2t --step 1 --why-not 'right 60'
[ "$(grep -c '^  [a-z0-9]' out)" -eq 2 ] || fail "--why-not shows other rules"
expect 0 "$af2" explain plate.af2t --at 1,1,0 --format json
json out level >/dev/null || fail "explain writes no JSON"
expect 0 "$af2" explain plate.af2t --step 5 --extract step.af2
expect 0 "$af2" test step.af2

expect 0 "$af2" explain plate.af2t --element 0
grep -q 'applied' out || fail "the step of an element did not apply a rule"
# An edge of an element of the mesh: one of its sides was the base edge of some step.
expect 0 "$af2" mesh "$plate" --size 0.5 -r mine.af2 -o plate.obj --quiet
found=0
for edge in $(awk '/^f / { print $2 - 1 "-" $3 - 1; print $3 - 1 "-" $4 - 1; print $4 - 1 "-" $2 - 1 }' plate.obj | tail -n 9); do
  "$af2" explain plate.af2t --edge "$edge" >out 2>err && grep -q '^face 1, step [0-9]*: ' out && found=1
done
[ $found = 1 ] || fail "no side of the last elements was a base edge"
expect 2 "$af2" explain plate.af2t --edge 0-100000; told 'the mesh has vertices 0 to'
expect 2 "$af2" explain plate.af2t --edge 0-0; told 'no step had this base edge'
expect 2 "$af2" explain plate.af2t --edge 12; told 'such as 12-34'
expect 2 "$af2" explain plate.af2t --edge 1-2 --step 1; told 'give one of them'
expect 2 "$af2" explain plate.af2t --element 100000; told 'the mesh has elements 0 to'
expect 2 "$af2" explain plate.af2t --element 1 --step 1; told 'give one of them'

expect 0 "$af2" stats plate.af2t
grep -q '^free triangle 1 ' out || fail "stats lacks a rule"
grep -q '^move  ' out || fail "stats lacks the moves of vertices"
expect 0 "$af2" stats plate.af2t --format json
[ "$(json out rules 0 chosen)" -gt 0 ] || fail "stats in JSON"
cp out stats.json
expect 0 "$af2" mesh "$plate" --size 0.5 -r mine.af2 --report run.json --statistics --trace both.af2t --quiet
cmp -s plate.af2t both.af2t || fail "statistics changed the trace"
python3 - stats.json run.json <<'PYTHON' || fail "statistics of a run and of its trace differ"
import json, sys
def counts(statistics):
    for rule in statistics["rules"]: del rule["seconds"]
    return statistics
stats, run = (json.load(open(name)) for name in sys.argv[1:])
assert counts(stats) == counts(run["statistics"])
elements = sum(source["elements"] for source in stats["sources"])
assert elements == run["triangles"] + run["quads"]
assert 0 < sum(source["worst"] for source in stats["sources"]) <= elements / 100 + 1
PYTHON
expect 2 "$af2" mesh "$plate" --size 0.5 --statistics; told '--statistics needs --report'
[ "$(json stats.json finish 0 number)" -gt 0 ] || fail "stats in JSON lacks the changes after the front"
expect 0 "$af2" mesh "$plate" --size 0.5 -r mine.af2 --no-optimize --trace raw.af2t --quiet
expect 0 "$af2" stats raw.af2t
! grep -q '^move  ' out || fail "stats counts changes that were not made"

# A stuck front: from the run to a test that fails, and passes once the rules are mended.
sed '/^test/,$d; /^rule "free triangle {k}"/,/^}/d; /^rule "fill/,/^}/d; /^rule .*vis a vis/,/^}/d' mine.af2 >tight.af2
expect 0 "$af2" mesh "$plate" --size 0.5 -r tight.af2 --trace tight.af2t --stuck-tests stuck.af2 --quiet
grep -q 'expect not stuck' stuck.af2 || fail "there are no tests of stuck places"
expect 1 "$af2" test stuck.af2
grep -q 'most frequent reason' out || fail "a failed test does not say why"
expect 0 "$af2" mesh "$plate" --size 0.5 -r tight.af2; told 'fronts got stuck on 1 face; most frequent reason: '; told '--stuck-tests'
expect 0 "$af2" mesh "$plate" --size 0.5 -r tight.af2 --report stuck.json
[ "$(json stuck.json stuck 0 places)" -gt 0 ] || fail "the report does not group stuck places"
[ -n "$(json stuck.json stuck 0 remedy)" ] || fail "a cause has no remedy"
expect 0 "$af2" explain tight.af2t --extract stuck_step.af2
grep -q 'no rule' out || fail "explain does not find the stuck step"
expect 1 "$af2" test stuck_step.af2
cp mine.af2 tight.af2
expect 0 "$af2" test stuck_step.af2
expect 1 "$af2" explain tight.af2t; told 'has changed since the trace was made'
expect 1 "$af2" trace diff plate.af2t tight.af2t
grep -q 'parts at step' out || fail "trace diff does not name the first different step"

# What a paving front does beside steps is in the trace.
cp "$2/rules/quad/paving.af2" rows.af2
sed '/^  at  *row smooth/d' rows.af2 >norows.af2
expect 0 "$af2" mesh "$plate" --size 0.25 --elements quad -r rows.af2 --trace rows.af2t --quiet
expect 0 "$af2" mesh "$plate" --size 0.25 --elements quad -r norows.af2 --trace norows.af2t --quiet
expect 1 "$af2" trace diff rows.af2t norows.af2t
grep -q 'first:  a row is complete, and [1-9][0-9]* vertices are moved' out || fail "trace diff does not name rows"
expect 0 "$af2" mesh "$plate" --size 0.25 --elements quad -r rows.af2 --report run.json --statistics --trace both.af2t --quiet
cmp -s rows.af2t both.af2t || fail "statistics changed the trace of a paving front"

# The page that plays a run.
expect 0 "$af2" trace view plate.af2t -o plate.html
grep -q 'wrote plate.html' out || fail "trace view does not say what it wrote"
cp plate.html once.html
expect 0 "$af2" trace view plate.af2t -o plate.html
cmp -s once.html plate.html || fail "the page of a trace changes"
expect 0 "$af2" trace view one.af2t -o part.html --face 12 --charts 10
grep -q 'has charts of 10 of the' out || fail "trace view does not say that charts are missing"
grep -q '^face 12: 2 fronts; kept: ' out || fail "trace view does not say which front was kept"
expect 0 "$af2" trace view one.af2t -o part.html --face 3 --from 2 --to 4
expect 2 "$af2" trace view one.af2t -o part.html --from 2; told 'need --face'
expect 2 "$af2" trace view one.af2t -o part.html --face 3 --from 4 --to 2; told 'comes after the last one'
expect 2 "$af2" trace view one.af2t -o part.html --face 3 --to 1000000; told 'face 3 has steps 1 to'
expect 2 "$af2" trace view one.af2t -o part.html --face 3 --from -1; told 'face 3 has steps 1 to'
expect 2 "$af2" trace view one.af2t -o part.html --face 700; told 'no steps of this face'
expect 2 "$af2" trace view one.af2t -o part.svg; told 'ends in .html'
expect 1 "$af2" trace view one.af2t -o nowhere/part.html; told 'nowhere'
[ ! -e part.svg ] || fail "a page was written in spite of an error"
expect 1 "$af2" trace view tight.af2t -o tight.html; told 'has changed since the trace was made'
[ ! -e tight.html ] || fail "a page was written in spite of an error"

# Bad input.
expect 2 "$af2" explain plate.af2t; told 'no front got stuck'
expect 2 "$af2" explain plate.af2t --step 100000; told 'has steps 1 to'
expect 2 "$af2" explain plate.af2t --face 7; told 'no steps of this face'
expect 2 "$af2" explain one.af2t --step 1; told '--step needs --face'
expect 2 "$af2" explain plate.af2t --step 1 --why-not 'right 6'; told 'did you mean'
expect 2 "$af2" explain plate.af2t --at 1,1; told 'x,y,z'
expect 1 "$af2" explain nothing.af2t; told 'cannot read'
expect 1 "$af2" explain mine.af2; told 'is not a trace of this version'
head -c 300 plate.af2t >cut.af2t
expect 1 "$af2" stats cut.af2t; told 'make it again'
head -c 2000 plate.af2t >cut.af2t
expect 1 "$af2" stats cut.af2t; told 'is damaged'
sed 's/"version":"[^"]*"/"version":"0.0.1"/' plate.af2t >old.af2t
expect 1 "$af2" explain old.af2t; told 'was written by version 0.0.1'
expect 1 "$af2" trace view old.af2t -o old.html; told 'was written by version 0.0.1'
expect 2 "$af2" mesh "$plate" --size 1 --trace-faces 1; told 'needs --trace'
finish
