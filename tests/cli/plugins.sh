#!/usr/bin/env bash
# Names that plugins register: every verb with a plugin, without it, and with bad ones.
. "$(dirname "$0")/support.sh"
rules=$2/examples/plugin/rules.af2
eggs=$3 no_entry=$4 other_version=$5 throws=$6 otherwise=$7
plate="$models/plate.poly"

# says TEXT: the last command said TEXT on stdout.
says() {
  grep -qF -- "$1" out || fail "stdout lacks '$1'"
}

# with the plugin, every verb that loads rules knows and evaluates its names
expect 0 "$af2" check "$rules" --plugin "$eggs"; says '0 errors'
grep -q R6 out && fail 'a name is missing in spite of the plugin'
expect 0 "$af2" test "$rules" --plugin "$eggs"; says '1 passed, 0 failed'
expect 0 "$af2" compile "$rules" --plugin "$eggs" --dump; says 'rule "free"'
expect 0 "$af2" draw "$rules" --plugin "$eggs" -o with.svg
expect 0 "$af2" draw "$rules" --plugin "$eggs" --coverage -o coverage.svg
expect 0 "$af2" doc "$rules" --plugin "$eggs" -o doc
expect 0 "$af2" eval "$rules" --rule free --plugin "$eggs"
expect 0 "$af2" mesh "$plate" --size 0.25 -r "$rules" --plugin "$eggs" --unchecked -o one.vtu -q
expect 0 "$af2" mesh "$plate" --size 0.25 -r "$rules" --plugin "$eggs" --unchecked -o two.vtu -q -j 2
same one.vtu two.vtu

# without it, what checks and shows rules goes on, and says what is not checked
expect 0 "$af2" check "$rules"
says "warning[AF2-R6]: 'egg' is declared here, but nothing implements it"
says 'rules are checked by the text alone'
says '--plugin FILE'
expect 1 "$af2" check --strict "$rules"
expect 0 "$af2" check --strict --allow R6 "$rules"
expect 0 "$af2" fmt --check "$rules"
expect 0 "$af2" compile "$rules"
expect 0 "$af2" draw "$rules" -o without.svg
expect 0 "$af2" doc "$rules" -o doc-without
grep -q 'tests not run' doc-without/index.html || fail 'the page does not say that tests were not run'

# and what would evaluate them does not begin
for verb in "test $rules" "eval $rules --rule free" "draw $rules --coverage" \
  "mesh $plate --size 0.25 -r $rules -o none.vtu"; do
  expect 1 "$af2" $verb
  told "rules.af2:7:14"
  told "error[AF2-R6]: 'egg' is declared here, but nothing implements it"
done
[ ! -e none.vtu ] || fail 'a mesh was written'

# bad plugins: one line each
bad() {
  expect 1 "$af2" check "$rules" --plugin "$1"
  says_one_line
  told "$2"
}
bad ./nowhere.so "--plugin './nowhere.so': there is no such file"
echo text >text.so
bad text.so "--plugin 'text.so': "
bad "$no_entry" 'it is no plugin of AF2'
bad "$other_version" "it was compiled for 'af2 9.9'"
bad "$throws" "'hull' cannot be registered"
expect 1 "$af2" check "$rules" --plugin "$eggs" --plugin "$otherwise"
says_one_line
told "'heat' is registered already"

# a plugin that contradicts the declaration is told of there
expect 1 "$af2" check "$rules" --plugin "$otherwise"
says "rules.af2:5:17"
says "'heat' is registered otherwise"
says 'function heat(number) : number'

exit "$((failures > 0))"
