#!/usr/bin/env bash
# The verbs for authors of rules: what they find, print and write, and with which exit code.
. "$(dirname "$0")/support.sh"
classic=tri/classic.af2

# says TEXT: the last command said TEXT on stdout.
says() {
  grep -qF -- "$1" out || fail "stdout lacks '$1'"
}

cat >good.af2 <<'END'
af2 1;

ruleset "good" {
  elements tri;
}

rule "right" quality 1 {
  front a -> b -> c;
  at    c (1.5, 0.866);
  new   d = a + (c - b);
  zone  a, b, c, d;
  tri   a b d, b c d;
  mirror "left";
}

test "a corner of 120 degrees" {
  front  p (0, 0) -> r (1, 0) -> s (1.5, 0.866);
  expect rule "right" with c = s;
}
END
sed 's/a b d, b c d/a b d, b c e/; s/0.866/0,866/' good.af2 >bad.af2
sed 's/expect rule "right"/expect rule "left"/; s/ with c = s//' good.af2 >failing.af2
sed '/mirror/d' good.af2 >warned.af2

# a library, which other files import: no rule set, no rules
cat >lib.af2 <<'END'
af2 1;

## Height of the even triangle.
const H = sqrt(3) / 2;
END
expect 0 "$af2" check lib.af2; says '0 rules, 0 errors'
expect 0 "$af2" fmt --check lib.af2
expect 0 "$af2" test lib.af2; says '0 passed, 0 failed'
expect 0 "$af2" doc lib.af2 -o lib-doc
grep -q 'sqrt' lib-doc/index.html || fail 'the page of a library lacks its constants'
expect 1 "$af2" draw lib.af2

# check
expect 0 "$af2" check good.af2; says '2 rules, 0 errors'
expect 1 "$af2" check bad.af2; says 'bad.af2:9:'
cat >partly.af2 <<'END'
af2 1;
ruleset "s" { elements tri; }
rule "narrow" quality 1 { front a -> b -> c; at c (0.5, 0.8); zone a, b, lerp(b, c, 0.5); tri a b c; }
rule "broken" quality 1 { new c = a + b; zone a, b, c; tri a b c; }
END
expect 1 "$af2" check partly.af2; says 'AF2-Z1'; says 'AF2-A1'
expect 0 "$af2" check --quick warned.af2; says 'AF2-M1'
expect 1 env AF2_COLOR=always "$af2" check bad.af2; says $'\x1b[1;31merror'
expect 1 env AF2_COLOR=always "$af2" check --format gcc bad.af2; says 'bad.af2:9:'
expect 1 env TERM=xterm "$af2" check bad.af2
! grep -q $'\x1b' out || fail 'colours in a file'
expect 1 "$af2" check --quick --strict warned.af2
expect 0 "$af2" check --quick --strict --allow M1 warned.af2
expect 1 "$af2" check nothing.af2; says 'nothing.af2'
expect 0 "$af2" check --quick "$classic"; says '12 rules'
expect 1 "$af2" check --quick --format json bad.af2 good.af2 warned.af2
[ "$(json out 0 file)" = bad.af2 ] || fail 'the first finding is not in bad.af2'
[ "$(json out 0 line)" = 9 ] || fail 'the first finding is not on line 9'
for key in column end_line end_column severity code message notes help; do
  json out 0 "$key" >/dev/null || fail "findings have no '$key'"
done
grep -q warned.af2 out || fail 'findings of a second file are missing'
expect 1 "$af2" check --quick --format sarif bad.af2
[ "$(json out version)" = 2.1.0 ] || fail 'no SARIF 2.1.0'
expect 1 "$af2" check --quick --format gcc bad.af2; says 'bad.af2:9:'
expect 2 "$af2" check --format xml good.af2
sed 's/0\.866/HEIGHT/; s/^  elements tri;/&\n}\nconst HEIGT = 0.866;/; /^}$/{x;s/^/x/;/^x$/{x;d};x}' good.af2 >misspelt.af2
cp misspelt.af2 kept.af2
expect 1 "$af2" check --quick misspelt.af2; says "did you mean 'HEIGT'?"
expect 1 "$af2" check --quick --diff misspelt.af2
cmp -s misspelt.af2 kept.af2 || fail '--diff changed the file'
expect 0 "$af2" check --quick --fix misspelt.af2
grep -q 'HEIGT)' misspelt.af2 || fail '--fix did not take the name that is meant'
expect 2 "$af2" check --fix - <good.af2
expect 2 "$af2" check
expect 1 bash -c "'$af2' check --quick - <bad.af2"; says '<stdin>:9:'
mkdir -p some/rules
cp good.af2 some/rules/one.af2; cp bad.af2 some/rules/two.af2
expect 1 "$af2" check --quick some; says '2 files'
mkdir none
expect 2 "$af2" check none; told 'no .af2 file'
expect 0 "$af2" check --pictures found tri/classic.af2
ls found/*.svg >/dev/null || fail 'no pictures of findings'

# test
expect 0 "$af2" test good.af2 --coverage; says '1 passed, 0 failed'; says 'never chosen: "left"'
expect 0 "$af2" test good.af2 --coverage --format json
[ "$(json out tests 0 title)" = 'a corner of 120 degrees' ] || fail 'tests are missing'
[ "$(json out coverage 0 file)" = good.af2 ] || fail 'the coverage of good.af2 is missing'
[ "$(json out coverage 0 rules 1 title)" = left ] || fail 'the coverage lacks rules'
[ "$(json out coverage 0 rules 1 chosen)" = False ] || fail 'no test applies "left"'
[ "$(json out coverage 0 rules 0 never_refused 0)" = zone ] || fail 'no test hits the zone of "right"'
for key in clauses exercised; do json out coverage 0 "$key" >/dev/null || fail "no '$key'"; done
expect 1 "$af2" test failing.af2; says 'FAIL'; says 'got:'
expect 1 "$af2" test good.af2 failing.af2 --format json
[ "$(json out 1 passed)" = False ] || fail 'the second test does not fail'
expect 1 "$af2" test bad.af2; told 'bad.af2:9'
expect 2 "$af2" test failing.af2 -k 'no such title'; told 'no title of a test contains it'

# fmt
expect 0 "$af2" fmt good.af2
cp out formatted.af2
expect 0 "$af2" fmt --check formatted.af2
tr -s ' ' <good.af2 >loose.af2
expect 1 "$af2" fmt --check loose.af2; says '@@'
expect 0 "$af2" fmt --check "$2/rules"  # what AF2 brings
expect 0 "$af2" fmt -w loose.af2
same loose.af2 formatted.af2
expect 1 "$af2" fmt -w bad.af2
cmp -s bad.af2 some/rules/two.af2 || fail 'a broken file was changed'

# eval
expect 0 "$af2" eval good.af2 --rule right --level 2 --match b=1.1,0 --match c=1.5,0.9 \
  --point 0.5,0.2 --point -1,-1 --segment -1,0.5,2,0.5 --env h=0.8 --format json
[ "$(json out refused)" = None ] || fail 'eval refuses'
[ "$(json out new d 1)" = 0.9 ] || fail 'a new vertex is elsewhere'
[ "$(json out points_in_zone)" = '[True, False]' ] || fail 'points_in_zone'
[ "$(json out segments_meet_zone)" = '[True]' ] || fail 'segments_meet_zone'
expect 0 "$af2" eval good.af2 --rule right --match c=9,9 --format json
[ "$(json out refused)" = pattern ] || fail 'a far vertex matches'
expect 2 "$af2" eval good.af2 --rule rigth; told 'right'
expect 2 "$af2" eval good.af2 --rule right --match c=1; told 'x,y'
expect 2 "$af2" eval good.af2 --rule right --match z=1,1; told "'z'"
expect 2 "$af2" eval good.af2 --rule right --level 0
expect 1 "$af2" eval bad.af2 --rule right; told 'bad.af2:9'

# draw, doc, compile
expect 0 "$af2" draw good.af2; says 'drew 2 rules -> good.svg'
expect 0 "$af2" draw good.af2 --rule left -o left.png --levels 1,3
[ "$(head -c 4 left.png | tail -c 3)" = PNG ] || fail 'no PNG'
expect 0 "$af2" draw good.af2 --rule right --match c=1.4,1 -o match.svg
expect 0 "$af2" draw good.af2 --coverage -o coverage.svg
expect 2 "$af2" draw good.af2 -o good.gif; told '.svg'
expect 2 "$af2" draw good.af2 --rule up; told 'there is no rule'
expect 2 "$af2" draw good.af2 --match c=1,1; told '--rule'
expect 0 "$af2" draw good.af2 --test 'a corner of 120 degrees' -o test.svg; says 'drew test "a corner of 120 degrees"'
expect 0 "$af2" draw good.af2 --test 'a corner of 120 degrees' -o again.svg
cmp -s test.svg again.svg || fail 'the picture of a test changes'
expect 2 "$af2" draw good.af2 --test 'a corner of 12 degrees'; told "did you mean 'a corner of 120 degrees'"
expect 2 "$af2" draw good.af2 --test 'zzz'; told 'the file has no such test'
expect 2 "$af2" draw good.af2 --test 'a corner of 120 degrees' --rule left; told 'give one of them'
expect 2 "$af2" draw good.af2 --test 'a corner of 120 degrees' -o test.gif; told '.svg'
expect 2 "$af2" draw good.af2 --test 'a corner of 120 degrees' --size 100; told 'needs at least 240 pixels'
expect 0 "$af2" doc good.af2 -o site
grep -q 'a corner of 120 degrees' site/index.html || fail 'the gallery lacks a test'
expect 0 "$af2" compile good.af2; says '2 rules, 2 of them affine'
expect 0 "$af2" compile --dump good.af2; says 'x = a.x - b.x + c.x'

# new
expect 0 "$af2" new ruleset mine.af2
expect 2 "$af2" new ruleset mine.af2; told 'exists'
expect 0 "$af2" new rule 'corner' --into mine.af2
expect 0 "$af2" check --quick --strict mine.af2
expect 0 "$af2" test mine.af2
expect 0 "$af2" fmt --check mine.af2
expect 2 "$af2" draw mine.af2 --size 10; told 'a whole number from 50 to 4000'
expect 2 "$af2" draw mine.af2 --levels 1,99; told 'the levels are 1 to 50'
expect 2 "$af2" test mine.af2 -k 'no such test'; told 'no title of a test contains it'
cp mine.af2 mine_before.af2
expect 1 "$af2" new rule 'corner' --into mine.af2; told 'has these titles already'; told 'corner'
same mine.af2 mine_before.af2
for file in none.af2 tri/classic -; do
  expect 2 "$af2" new rule 'corner' --into $file; told "there is no file '$file'"
done
printf 'notes on rules\n' >notes.txt
cp notes.txt notes_before.txt
expect 1 "$af2" new rule 'corner' --into notes.txt; told 'notes.txt:1:1'; told 'was not changed'
same notes.txt notes_before.txt
expect 0 "$af2" new rule 'on stdout'; says 'rule "on stdout"'

# explain-code
expect 0 "$af2" explain-code A1; says 'AF2-A1'
expect 0 "$af2" explain-code; says 'Z1'
expect 2 "$af2" explain-code Q7; told 'Q7'

rm -f out err
left=$(find . -name '*.tmp')
[ -z "$left" ] || fail "left behind: $left"
# slips on the command line
expect 2 "$af2" check; told 'FILES is required: rule files, folders with rule files, or - for stdin'
expect 2 "$af2" check good.af2 --format xml; told "--format 'xml': choose one of pretty, json, sarif, gcc"
expect 2 "$af2" check good.af2 --samples 0; told 'give a whole number from 1 to'
expect 2 "$af2" check good.af2 --allow Q9; told "--allow 'Q9': there is no such code"
expect 2 "$af2" eval good.af2 --rule right --level 1e9; told "--level '1e9': give a whole number"
expect 2 "$af2" eval good.af2 --rule right --env turm=3; told "the environment has no 'turm'; did you mean 'turn'?"
expect 0 "$af2" eval good.af2 --rule right --env 'turn(c)=120' --env h=2
expect 2 "$af2" new rule ' '; told 'the title is empty'
expect 2 "$af2" new rules x; told "WHAT 'rules': choose one of ruleset, rule"

finish
