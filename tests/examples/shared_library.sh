#!/usr/bin/env bash
# shared_library.sh PROGRAM LIBRARY SOURCE: a program that uses the shared library meshes a model, and the
# library defines nothing for programs but what the public headers mark with AF2_EXPORT.
set -euo pipefail
program=$1 library=$2 source=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$program" "$source/examples/models/cylinder.step" 0.5 "$work/cylinder.vtu"
[ -s "$work/cylinder.vtu" ]

# Names in anonymous namespaces and those of internal classes and functions are the first to leak.
nm -D --defined-only -C "$library" | cut -d' ' -f3- >"$work/symbols"
for internal in 'af2::Front::' 'af2::Neighborhood' 'af2::dsl::Lexer' 'af2::dsl::ClauseCompiler' \
    'af2::geometry::FaceSurface::' '(anonymous namespace)'; do
  ! grep -F "$internal" "$work/symbols" || { echo "-> $internal is visible"; exit 1; }
done
for public in 'af2::AF2Algorithm::execute' 'af2::dsl::loadRules' 'af2::geometry::meshModel' \
    'af2::geometry::writeMesh' 'typeinfo for af2::InputError'; do
  grep -qF "$public" "$work/symbols" || { echo "-> $public is hidden"; exit 1; }
done
