#!/usr/bin/env bash
# The readers of STEP and IGES files, some algorithms of OpenCASCADE and the writers of some formats are libraries beside the
# program.
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
expect 1 alone/af2 mesh "$models/bolt_on_plate.brep" --imprint --size 1 -o imprinted.vtu
says_one_line
told "the library 'af2-algorithms.so' that belongs to this program is not in"
[ ! -e imprinted.vtu ] || fail "there is a mesh of a model that was not imprinted"
if ldd alone/af2 | grep -qE 'TK(STEP|XCAF|IGES|V3d|BO|Mesh)|cairo'; then fail "the program is linked with what few runs need"; fi

# The same holds for writers that need libraries of others, whether these were built or not.
for format in med exo cgns; do
  expect 2 alone/af2 mesh "$models/plate.poly" --size 0.5 -o plate.$format
  told "does not lie with this program; choose another format, install the package af2-formats, or build AF2 where"
done
for library in med exodus cgns; do printf 'no library' >alone/af2-$library.so; done
for format in med exo cgns; do
  expect 1 alone/af2 mesh "$models/plate.poly" --size 0.5 -o plate.$format -o beside.obj
  told "cannot load a part of this program"
  [ ! -e plate.$format ] || fail "there is a file plate.$format"
  [ -e beside.obj ] || fail "the other file is missing"
  rm -f beside.obj
done
[ -z "$(ls | grep tmp)" ] || fail "temporary files are left"
rm alone/af2-*.so
if ldd alone/af2 | grep -qE 'hdf5|netcdf|med|cgns|mpi'; then fail "the program is linked with libraries of formats"; fi

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

# Where the build has bound copies of OpenCASCADE's libraries, the program uses them, and does the same without them.
bind=$(dirname "$af2")/../geometry/bind-libraries
if [ -x "$bind" ]; then
  ldd "$af2" >libraries
  grep -q 'lib/af2/occ/libTKernel' libraries || fail "the program does not use the bound copies: $(cat libraries)"
  ldd installed/bin/af2 | grep -q 'lib/af2/occ' && fail "there are no copies to use"
  # A copy of a variable in the program would be another one than that of a bound library.
  readelf -rW "$af2" | grep R_X86_64_COPY | grep -v @GLIBC && fail "the program has copies of variables"
  # The dynamic linker finds the counters of handles in the program (reference_counts.cpp).
  [ "$(readelf --dyn-syms -W "$af2" | grep -c ' [1-9][0-9]* _ZNK18Standard_Transient19..crementRefCounterEv')" = 2 ] ||
    fail "the program does not offer its counters of handles"
  echo "no library" >libTKMath.so.7
  echo "an older copy" >installed/libTKMath.so.7
  expect 1 "$bind" installed libTKMath.so.7
  told "bind-libraries: 'libTKMath.so.7': this is not a shared library"
  [ ! -e installed/libTKMath.so.7 ] || fail "there is still the older copy"
  expect 1 "$bind" installed missing.so
  told "bind-libraries: 'missing.so': it cannot be read"
  expect 2 "$bind" installed
fi

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
