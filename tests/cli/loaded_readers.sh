#!/usr/bin/env bash
# The readers of STEP and IGES files are libraries beside the program.
. "$(dirname "$0")/support.sh"

# What runs without them does not load them.
mkdir alone
cp "$af2" alone/af2
export AF2_RULES=$2/rules
expect 0 alone/af2 version
expect 0 alone/af2 mesh "$models/plate.poly" --size 0.5 -o plate.vtu
expect 0 alone/af2 mesh "$models/cylinder.brep" --size 1 -o brep.vtu
expect 1 alone/af2 mesh "$models/cylinder.step" --size 1 -o step.vtu
says_one_line
told "the library 'af2-step.so' that belongs to this program is not in"
told "copy or install it along with the program"
[ ! -e step.vtu ] || fail "there is a mesh of a model that was not read"
if ldd alone/af2 | grep -qE 'TK(STEP|XCAF|IGES|V3d)'; then fail "the program is linked with readers"; fi

# Installed, they lie in a folder of the program's libraries.
mkdir -p installed/bin
cp "$af2" installed/bin/
for library in lib/af2 lib64/af2 "lib/$(gcc -dumpmachine 2>/dev/null)/af2"; do
  mkdir -p "installed/$library"
  cp "$(dirname "$af2")"/af2-*.so "installed/$library/"
done
expect 0 installed/bin/af2 mesh "$models/cylinder.step" --size 1 -o installed.vtu
expect 0 "$af2" mesh "$models/cylinder.step" --size 1 -o built.vtu
same installed.vtu built.vtu

# A library that is none, or that of another format.
for content in "no library" "$(printf '\177ELF')"; do
  printf '%s' "$content" >alone/af2-step.so
  expect 1 alone/af2 mesh "$models/cylinder.step" --size 1 -o step.vtu
  says_one_line
  told "cannot load a part of this program"
done
cp "$(dirname "$af2")/af2-step.so" alone/af2-iges.so
printf '%-72sS0000001\n' "a start" >start.igs
expect 1 alone/af2 mesh start.igs --size 1 -o iges.vtu
says_one_line

finish
