#!/usr/bin/env bash
# launcher.sh AF2 SOURCE: ./af2 asks for packages and builds only if something has changed.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$2/af2" "$work/af2"
cd "$work"
mkdir .ci engine dsl geometry cli
touch CMakeLists.txt packages.txt engine/a.cpp engine/b.cpp
# A build that counts how often it runs, and makes a program that says so.
cat >.ci/build.sh <<'SH'
say() { echo "$@" >&2; }
install_packages() { :; }
warnings_setting() { echo ON; }
configure() { mkdir -p build/cli && touch build/build.ninja; }
with_build_lock() { "$@"; }
build() {
  [ ! -f broken ] || exit 1
  echo build >>builds
  printf '#!/bin/sh\necho "ran $*"\n' >build/cli/af2
  chmod +x build/cli/af2
}
SH

# runs COUNT: ./af2 runs, and so many builds have been made.
runs() {
  [ "$(./af2 mesh x)" = 'ran mesh x' ] || { echo "the program did not run"; exit 1; }
  [ "$(wc -l <builds)" -eq "$1" ] || { echo "$(wc -l <builds) builds instead of $1, line ${BASH_LINENO[0]}"; exit 1; }
  sleep 0.02
}
runs 1
runs 1
touch engine/a.cpp && runs 2
runs 2
rm engine/b.cpp && runs 3
touch packages.txt && runs 4
runs 4
rm build/cli/af2 && runs 5

touch broken engine/a.cpp
if ./af2 mesh x; then echo "a build that fails goes unnoticed"; exit 1; fi
[ -z "$(find build -name 'tmp.*')" ] || { echo "a file is left"; exit 1; }
rm broken
runs 6
