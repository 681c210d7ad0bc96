#!/usr/bin/env bash
# A run that is told to stop ends soon, with exit code 4, and leaves no half file.
. "$(dirname "$0")/support.sh"

"$af2" mesh "$models/die.step" --size 0.01 -o die.vtu --report die.json >out 2>err </dev/null &
run=$!
sleep 2
kill -TERM $run
begin=$(date +%s%N)
code=0
wait $run || code=$?
milliseconds=$((($(date +%s%N) - begin) / 1000000))
[ $code -eq 4 ] || fail "exit code $code, expected 4"
[ $milliseconds -lt 5000 ] || fail "it took $milliseconds ms to stop"
told 'stopped'
[ "$(json die.json status)" = cancelled ] || fail "status in the report"
[ -z "$(find . -name '*.tmp')" ] || fail "a temporary file is left"

# A signal to the whole group reaches the run more than once, and stops it all the same.
code=0
timeout --signal TERM 2 "$af2" mesh "$models/die.step" --size 0.01 --report group.json >out 2>err </dev/null || code=$?
[ $code -eq 124 ] || fail "exit code $code of timeout, expected 124"
told 'stopped'
[ "$(json group.json status)" = cancelled ] || fail "status in the report after a signal to the group"
finish
