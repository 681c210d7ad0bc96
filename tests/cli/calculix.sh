#!/usr/bin/env bash
# CalculiX solves with the elements, sets and sides of .inp files: a strip that is pulled gets longer as it should.
. "$(dirname "$0")/support.sh"
command -v ccx >/dev/null || { echo "no CalculiX"; exit 77; }
export OMP_NUM_THREADS=1

cat >strip.poly <<'E'
4 2 0 0
1 0 0
2 10 0
3 10 2
4 0 2
4 1
1 1 2 3
2 2 3 2
3 3 4 4
4 4 1 1
0
