#!/usr/bin/env bash
# The same bytes as af2 mesh, with any number of processes and threads.
. "$(dirname "$0")/support.sh"

# alike RANKS... -- OPTION...
alike() {
  local counts=()
  while [ "$1" != -- ]; do counts+=("$1"); shift; done
  shift
  expect 0 "$af2" mesh "$@" -q -o one.vtu -o one.msh --report one.json
  for ranks in "${counts[@]}"; do
    expect 0 on "$ranks" "$@" -q -o two.vtu -o two.msh --report two.json
    same one.vtu two.vtu
    same one.msh two.msh
    [ "$(json one.json quality)" = "$(json two.json quality)" ] || fail "the reports differ: $*"
  done
}

# apart RANKS... -- OPTION...: the same with faces in the memory of those who have meshed them, and on their disks.
apart() {
  local counts=()
  while [ "$1" != -- ]; do counts+=("$1"); shift; done
  shift
  "$af2" mesh "$@" -q -o one.vtu -o one.msh2 --report one.json >out 2>err </dev/null
  local code=$?
  for ranks in "${counts[@]}"; do
    for where in "" --stream; do
      expect $code on "$ranks" "$@" -q $where -o two.vtu -o two.msh2 --report two.json
      same one.vtu two.vtu
      same one.msh2 two.msh2
      [ "$(json one.json fingerprint)" = "$(json two.json fingerprint)" ] || fail "the reports differ: $*"
    done
  done
}

alike 1 2 3 5 8 -- "$models/die.step" --size 1
apart 1 2 3 5 8 -- "$models/die.step" --size 1
apart 3 -- "$models/die.step" --size 1 --threads 3
apart 1 2 3 -- "$models/plate.poly" --size 0.015
apart 3 -- "$models/hills.brep" --size 1.5 --curvature 24
apart 3 -- "$models/die.step" --size 6 --strict-rules
alike 3 -- "$models/die.step" --size 1 --threads 3
alike 2 -- "$models/plate.poly" --size 0.1 --layers @1=0.02,1.3,3
# A face that is cut into pieces, which all processes mesh.
alike 1 2 3 -- "$models/plate.poly" --size 0.015
alike 2 -- "$models/plate.poly" --size 0.015 --threads 3
# Several runs over the faces, of which the processes must take the same decisions.
alike 3 -- "$models/brickhole.step" --size 1 --chord 0.02 --proximity 2 --fewest
alike 2 -- "$models/die.step" --size 0.8 --merge
alike 2 -- "$models/cylinder.brep" --size 0.5 --elements quad
"$af2" mesh "$models/cylinder.step" --size 0.3 -q -o cylinder.stl
alike 3 -- cylinder.stl --size 0.4 --order 2
# Faces that fail or are tried again.
alike 3 -- "$models/hills.brep" --size 1.5 --curvature 24
finish
