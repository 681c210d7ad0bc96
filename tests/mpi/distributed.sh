#!/usr/bin/env bash
# distributed.sh PROGRAM SOURCE AF2: the example that uses a crew and its parts from C++; AF2 is the program af2.
. "$(dirname "$0")/../cli/support.sh"
command -v mpirun >/dev/null || exit 77
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 TMPDIR=$work
program=$1

expect 0 "$3" mesh "$models/die.step" -s 1 -q --report whole.json -o whole.vtu
elements=$(grep -oE '"triangles": [0-9]+' whole.json | grep -oE '[0-9]+')
for ranks in 1 3; do
  expect 0 timeout 60 mpirun --oversubscribe -n $ranks "$program" "$models/die.step" 1
  [ "$(grep -c '^rank ' out)" -eq $ranks ] || fail "not each process has a part"
  grep -q "of $elements elements" out || fail "not the mesh of af2 mesh"
done
expect 1 timeout 60 mpirun --oversubscribe -n 2 "$program" none.step 1
finish
