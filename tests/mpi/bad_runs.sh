#!/usr/bin/env bash
# Wrong command lines and dead processes: a clear error, an exit code, no half file, no process left behind.
. "$(dirname "$0")/support.sh"

# refuses CODE TEXT OPTION...
refuses() {
  local code=$1 text=$2
  shift 2
  expect "$code" on 3 "$@"
  told "$text"
  [ "$(grep -c '^af2-mpi: error: ' err)" -eq 1 ] || fail "not one error"
}

refuses 1 "there is no file 'none.step'" none.step --size 1
refuses 2 "--bogus" "$models/die.step" --size 1 --bogus
refuses 2 "there is no face 99" "$models/die.step" --size 1 --face-size 99=1
refuses 1 "ask for sizes" "$models/die.step" --size 0.0001
refuses 2 "use af2 mesh" "$models/die.step" --size 1 --trace t.af2t
refuses 1 ".pvtu or .msh" "$models/die.step" --size 1 --parts mesh.obj
refuses 1 "cannot write" "$models/die.step" --size 1 --parts none/mesh.msh

printf 'af2 1;\nruleset "x" { elements tri; }\nrule "r" quality 1 { tri a b c; }\n' >bad.af2
expect 1 on 3 "$models/die.step" --size 1 -r bad.af2
[ "$(grep -c '^error.AF2-R1' err)" -eq 1 ] || fail "the fault of the rules is not told once"
expect 1 on 2 "$models/die.step" --size 0.0001 --report why.json
grep -q "ask for sizes" why.json || fail "the report does not say why"

# A process dies in the middle, with the first one waiting for it. Other tests may have processes of the program, too.
on 3 "$models/die.step" --size 0.02 -o killed.vtu --parts killed.pvtu >out 2>err &
run=$!
for i in $(seq 100); do
  sleep 0.1
  victim=$(pgrep -f "^$mpi .*-o killed.vtu" | tail -1)
  [ -n "$victim" ] && [ "$i" -ge 15 ] && break
done
kill -9 "$victim"
wait "$run"
code=$?
[ "$code" -ne 0 ] || fail "exit code 0 after a process was killed"
told "no file was left incomplete"
told "Killed"
[ -z "$(ls | grep killed)" ] || fail "files were left behind: $(ls)"
sleep 1
pgrep -f "^$mpi .*-o killed.vtu" && fail "processes were left behind"

# One that has not enough memory.
expect 1 timeout 100 mpirun --oversubscribe -n 1 "$mpi" "$models/die.step" --size 0.01 -o less.vtu : \
  -n 1 bash -c "ulimit -v 400000; exec '$mpi' '$models/die.step' --size 0.01 -o less.vtu"
told "there is not enough memory"
[ -e less.vtu ] && fail "a file was written without a process"
finish
