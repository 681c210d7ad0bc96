#!/usr/bin/env bash
# A model through standard input gives the same mesh as from a file; its content tells its format.
. "$(dirname "$0")/support.sh"
export TMPDIR=$work/temporary
mkdir "$TMPDIR"

# from FILE ARGUMENT...: the file through a pipe
from() {
  local model=$1
  shift
  expect 0 bash -c 'cat "$1" | "$2" mesh - "${@:3}"' bash "$model" "$af2" "$@"
}

expect 0 "$af2" mesh "$models/die.step" --size 2 -o die.stl -o die.obj -o die.ply -o die.vtu -o die.vtk -o die.msh
printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n' >four.off
printf 'splinecurves2dv2\n2\npoints\n1 0 0\n2 4 0\n3 4 4\n4 0 4\nsegments\n1 0 2 1 2\n1 0 2 2 3\n1 0 2 3 4\n1 0 2 4 1\n' >square.in2d
for model in "$models/cylinder.step" "$models/cylinder.brep" "$models/plate.poly" die.stl die.obj die.ply die.vtu die.vtk \
  die.msh four.off square.in2d; do
  expect 0 "$af2" mesh "$model" --size 2 -o file.obj
  from "$model" --size 2 -o pipe.obj
  same file.obj pipe.obj
done

# /dev/stdin is the same, and so is a given format.
expect 0 bash -c '"$1" mesh /dev/stdin --size 2 -o pipe.obj <"$2"' bash "$af2" "$models/cylinder.step"
expect 0 "$af2" mesh "$models/cylinder.step" --size 2 -o file.obj
same file.obj pipe.obj
from "$models/plate.poly" --format poly --size 2 -o pipe.obj

# What cannot be used.
refused() {
  local code=$1 text=$2
  shift 2
  expect "$code" bash -c 'printf "%s" "$1" | "$2" mesh - --size 1 -o no.vtu "${@:3}"' bash "$text" "$af2" "$@"
  says_one_line
  [ ! -e no.vtu ] || fail "there is a mesh"
}
refused 1 ""; told "standard input is empty; pipe a model into it"
refused 1 "some text"; told "its content does not tell its format; give --format, one of step"
refused 1 "ISO-10303-21;"; told "standard_input.cad: this STEP file is damaged or truncated"
refused 1 "OFF"; told "is truncated"
refused 2 "OFF" --format doc; told "--format doc: choose one of step"
refused 2 "OFF" --trace t.af2t; told "--trace needs a model in a file"
expect 2 "$af2" mesh "$models/die.step" --size 1 --format step; told "--format is for a model from standard input"

expect 1 bash -c 'TMPDIR=/nowhere/at/all "$1" mesh - --size 2 <"$2"' bash "$af2" "$models/plate.poly"
told 'set TMPDIR to a folder that exists'
[ -z "$(ls "$TMPDIR")" ] || fail "left behind: $(ls "$TMPDIR")"
finish
