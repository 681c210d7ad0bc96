#!/usr/bin/env bash
# Meshes whose faces are put on disk when they are done: the same bytes, less memory, and nothing left.
. "$(dirname "$0")/support.sh"

# The same files and the same report, apart from times and the last digits of means.
alike() {
  python3 - "$1" "$2" <<'PYTHON' || fail "the reports $1 and $2 differ"
import json, sys
one, two = (json.load(open(name)) for name in sys.argv[1:])
def clean(value):
    if isinstance(value, dict): return {k: clean(v) for k, v in value.items() if k != "seconds"}
    if isinstance(value, list): return [clean(v) for v in value]
    return float("%.9g" % value) if isinstance(value, float) else value
sys.exit(clean(one) != clean(two))
PYTHON
}
compare() {  # FORMATS OPTIONS...
  local formats=$1 files="" name
  shift
  for name in $formats; do files="$files -o usual.$name"; done
  "$af2" mesh "$@" $files --report usual.json >usual.out 2>usual.err </dev/null
  local code=$?
  for threads in 1 2; do
    expect $code "$af2" mesh "$@" ${files//usual/streamed} --report streamed.json --stream --threads $threads
    for name in $formats; do same usual.$name streamed.$name; done
    alike usual.json streamed.json
    grep -v '^seconds' usual.out >usual.text
    grep -v '^seconds' out | cmp -s - usual.text || fail "the summaries differ: $*"
  done
}
all="vtu vtk msh2 stl obj ply"
compare "$all" "$models/die.step" --size 0.5
compare "vtu vtk msh2" "$models/die.step" --size 1 -r quad/classic --edges
compare "$all" "$models/brickhole.step" --size 0.3 --layers 3,4=0.05,1.2,2
compare "$all" "$models/plate.poly" --size 0.1 --scale 0.1
compare "$all" "$models/cylinder.step" --size 0.05 --faces 1
# Faces that fail, and faces that are tried again.
compare "$all" "$models/die.step" --size 6 --strict-rules
compare "$all" "$models/hills.brep" --size 3 --grading 0.1

# Memory: of many faces that are alike it falls to a fraction.
memory() { /usr/bin/time -f %M -o kilobytes "$@" >out 2>err </dev/null || fail "it failed: $*"; tail -n 1 kilobytes; }
if [ -x /usr/bin/time ]; then
  little=$(memory "$af2" mesh "$models/die.step" --size 5 --threads 1 -o memory.ply)
  usual=$(memory "$af2" mesh "$models/die.step" --size 0.05 --threads 1 -o memory.ply)
  streamed=$(memory "$af2" mesh "$models/die.step" --size 0.05 --threads 1 --stream -o memory.ply)
  [ $((2 * (streamed - little))) -lt $((usual - little)) ] ||
    fail "$streamed kB with --stream, $usual kB without, $little kB for next to nothing"
fi

# Where the mesh does not fit, but its faces one by one do, that is done without being asked.
expect 0 "$af2" mesh "$models/die.step" --size 0.1 --threads 1 --max-memory 4M -o auto.vtu
grep -q 'put on disk' out || fail "nothing says that faces were put on disk"
expect 0 "$af2" mesh "$models/die.step" --size 0.1 --threads 1 -o usual.vtu
same usual.vtu auto.vtu
expect 1 "$af2" mesh "$models/die.step" --size 0.1 --threads 1 --max-memory 4M -o auto.msh
told '--stream'
expect 1 "$af2" mesh "$models/die.step" --size 0.1 --threads 1 --max-memory 1M -o auto.vtu
told 'times as large'

# What cannot be had with it is said before the run.
expect 2 "$af2" mesh "$models/die.step" --size 1 --stream -o x.msh; told "'x.msh' needs the whole mesh in memory"
expect 2 "$af2" mesh "$models/die.step" --size 1 --stream --order 2 -o x.vtu; told '--order 2'
expect 2 "$af2" mesh "$models/die.step" --size 1 --stream --merge -o x.vtu; told '--merge'
expect 2 "$af2" mesh "$models/die.step" --size 1 --stream --periodic x -o x.vtu; told '--periodic'
expect 2 "$af2" mesh "$models/die.step" --size 1 --stream --statistics --report x.json; told '--statistics'
[ ! -e x.vtu ] || fail "a refused run wrote a file"

# Killed at odd moments, it leaves neither half a file nor what it had put on disk.
mkdir killed
"$af2" mesh "$models/die.step" --size 0.1 -o whole.vtu >out 2>err </dev/null
for seconds in 0.1 0.2 0.3 0.4 0.6; do
  echo old >killed/die.vtu
  { timeout -s KILL $seconds "$af2" mesh "$models/die.step" --size 0.1 --stream -o killed/die.vtu >out 2>err </dev/null; } 2>/dev/null
  [ "$(head -c 4 killed/die.vtu)" = old ] || cmp -s killed/die.vtu whole.vtu || fail "half a file after $seconds s"
  [ "$(ls -A killed)" = die.vtu ] || fail "something is left: $(ls -A killed)"
done

# A disk that fills up while faces are put there.
if (ulimit -f 64) 2>/dev/null; then
  echo old >killed/die.vtu
  (ulimit -f 64; trap '' XFSZ; exec "$af2" mesh "$models/die.step" --size 0.1 --stream -o killed/die.vtu) >out 2>err </dev/null
  [ $? -eq 1 ] || fail "a disk without room did not matter"
  told "cannot keep the mesh in 'killed'"
  [ "$(cat killed/die.vtu)" = old ] || fail "half a file after a full disk"
  [ "$(ls -A killed)" = die.vtu ] || fail "something is left: $(ls -A killed)"
fi
expect 2 "$af2" mesh "$models/die.step" --size 1 --stream -o nowhere/die.vtu
finish
