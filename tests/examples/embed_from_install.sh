#!/usr/bin/env bash
# embed_from_install.sh SOURCE BUILD COMPILER: installs AF2 to a new prefix, builds examples/embedding
# against it as a project of its own, and runs both that and the installed program.
set -euo pipefail
source=$1 build=$2 compiler=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --prefix "$work/prefix" >"$work/log" || { cat "$work/log"; exit 1; }
cp -r "$source/examples/embedding" "$work/embedding"  # nothing of AF2's sources is in reach there
cmake -S "$work/embedding" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_PREFIX_PATH="$work/prefix" >"$work/log" 2>&1 &&
  cmake --build "$work/build" >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }

cp "$source/examples/models/cylinder.step" "$work/part.step"
cd "$work"
build/embedding part.step 0.5 embedded.msh
env -u AF2_RULES prefix/bin/af2 mesh part.step --size 0.5 -o program.msh
cmp embedded.msh program.msh
