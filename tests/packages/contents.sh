#!/usr/bin/env bash
# contents.sh BUILD: the Debian packages of this build hold what they should, and depend on what they need. Exit
# code 77: there is no dpkg. tests/packages/on_bare_debian installs them.
set -euo pipefail
build=$1
command -v dpkg-shlibdeps >/dev/null && command -v cpack >/dev/null || { echo "no dpkg-dev"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
cpack --config "$build/CPackConfig.cmake" -G DEB -B "$work" >log 2>&1 || { cat log; exit 1; }
failures=0
fail() { echo "FAILED: $*"; failures=$((failures + 1)); }

# holds PACKAGE PATTERN...: a file whose path matches each pattern is in the package, and is not empty.
holds() {
  local package=$1 pattern
  shift
  dpkg-deb --fsys-tarfile "$package"_*.deb | tar -tv | awk '$3 > 0 { print $6 }' >files
  for pattern; do grep -qE "^\./usr/$pattern\$" files || fail "$package lacks $pattern"; done
}
# needs PACKAGE NAME...: it depends on packages of these names.
needs() {
  local package=$1 name depends
  shift
  depends=$(dpkg-deb -f "$package"_*.deb Depends)
  for name; do [[ ", $depends" == *", $name"* ]] || fail "$package does not depend on $name: $depends"; done
}

holds af2 bin/af2 lib/.*/?af2-step.so lib/.*/?af2-iges.so lib/.*/?af2-algorithms.so share/af2/rules/tri/even.af2 share/man/man1/af2.1.gz \
  share/man/man1/af2-mesh.1.gz share/man/man1/af2-draw.1.gz share/bash-completion/completions/af2 share/zsh/vendor-completions/_af2 \
  share/fish/vendor_completions.d/af2.fish share/doc/af2/copyright share/doc/af2/changelog
if [ -e "$build/package-scripts" ]; then
  holds af2 'lib/.*/?af2/bind-libraries'
  dpkg-deb -e af2_*.deb scripts
  [ -x scripts/postinst ] && [ -x scripts/prerm ] && grep -q 'libTKernel' scripts/triggers || fail "af2 lacks scripts"
fi
! grep -qE 'libTK' files || fail "af2 has libraries of OpenCASCADE"
! grep -qE '\.h$|\.a$|\.pc$' files || fail "af2 has files of libaf2-dev"
needs af2 libc6 libocct-data-exchange libtbb12 libcairo2

holds libaf2-dev include/af2/engine/algorithm.h include/af2/dsl/rule_file.h lib/.*cmake/af2/af2-config.cmake \
  lib/.*pkgconfig/af2.pc share/doc/libaf2-dev/copyright
needs libaf2-dev af2
if ls libaf2-0*.deb >/dev/null 2>&1; then
  library=$(ls libaf2-0*.deb | cut -d_ -f1)
  holds "$library" 'lib/.*libaf2.so.[0-9.]*' "share/doc/$library/copyright"
  needs libaf2-dev libaf2-0
fi

if ls python3-af2_*.deb >/dev/null 2>&1; then
  holds python3-af2 lib/python3/dist-packages/af2/__init__.py 'lib/python3/dist-packages/af2/_af2.*\.so'
  needs python3-af2 python3 libc6 libcairo2
fi

if ls af2-formats_*.deb >/dev/null 2>&1; then needs af2-formats af2; fi

# Nothing is in two packages, and the program of the package runs.
for package in *.deb; do dpkg-deb --fsys-tarfile "$package" | tar -t | grep -v '/$'; done | sort | uniq -d >twice
[ ! -s twice ] || fail "in two packages: $(cat twice)"
dpkg-deb -x af2_*.deb af2
env -u AF2_RULES af2/usr/bin/af2 check tri/even >log 2>&1 || fail "the program does not run: $(cat log)"
[ "$failures" -eq 0 ] || exit 1
echo "all as expected"
