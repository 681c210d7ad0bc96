#!/usr/bin/env bash
# embed_from_install.sh SOURCE BUILD COMPILER: installs AF2 to a new prefix, builds the examples against it as projects
# of their own, and runs both these and the installed program.
set -euo pipefail
source=$1 build=$2 compiler=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cmake --install "$build" --prefix "$work/prefix" >"$work/log" || { cat "$work/log"; exit 1; }
cp -r "$source/examples" "$work/examples"  # nothing else of AF2's sources is in reach there
build_example() {
  local name=$1
  cmake -S "$work/examples/$name" -B "$work/$name/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_PREFIX_PATH="$work/prefix" >"$work/log" 2>&1 &&
    cmake --build "$work/$name/build" >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
}

# project NAME: a project of its own around the CMakeLists.txt of an example that AF2 builds, too.
project() {
  { printf 'cmake_minimum_required(VERSION 3.25)\nproject(own LANGUAGES CXX)\nfind_package(af2 REQUIRED COMPONENTS dsl geometry)\nadd_library(af2_build INTERFACE)\n'
    cat "$source/examples/$1/CMakeLists.txt"; } >"$work/examples/$1/CMakeLists.txt"
  build_example "$1"
}

build_example embedding
build_example own_shape
if [ -n "$(find "$work/prefix" -name af2-mpi-config.cmake)" ]; then build_example distributed; fi
project torus
project registered_shape
project plugin

# What they link holds no bytecode, which every program would compile again.
! readelf -S --wide "$work"/prefix/lib/*/libaf2_engine.a "$work"/prefix/lib/libaf2_engine.a 2>/dev/null |
  grep -q gnu.lto || { echo "-> the installed engine has link-time bytecode"; exit 1; }

# Without CMake: what pkg-config says is enough.
if command -v pkg-config >/dev/null; then
  export PKG_CONFIG_PATH=$(dirname "$(find "$work/prefix" -name af2.pc)")
  read -ra flags <<<"$(pkg-config --cflags af2)"
  read -ra libraries <<<"$(pkg-config --libs af2)"
  "$compiler" "${flags[@]}" -DRULES="\"$(pkg-config --variable=rulesdir af2)/tri/even.af2\"" \
    "$work/examples/embedding/main.cpp" -o "$work/without_cmake" "${libraries[@]}"
fi

cp "$source/examples/models/cylinder.step" "$work/part.step"
cd "$work"
embedding/build/embedding part.step 0.5 embedded.msh
env -u AF2_RULES prefix/bin/af2 mesh part.step --size 0.5 -o program.msh
cmp embedded.msh program.msh
if [ -x without_cmake ]; then
  LD_LIBRARY_PATH=$(dirname "$PKG_CONFIG_PATH") ./without_cmake part.step 0.5 without_cmake.msh
  cmp embedded.msh without_cmake.msh
fi
own_shape/build/own_shape 0.5 pipe.msh | grep -q '^inlet: [1-9]' || { echo "-> a name is missing"; exit 1; }
grep -aq '"outlet"' pipe.msh
torus/build/torus prefix/share/af2/rules/tri/classic.af2 0.25 torus.vtu
registered_shape/build/registered_shape "$source/examples/models/plate.poly" 0.25 plate.vtu
prefix/bin/af2 mesh "$source/examples/models/plate.poly" --size 0.25 -r "$source/examples/plugin/rules.af2" \
  --plugin plugin/build/eggs.so -o eggs.vtu --quiet
for file in torus.vtu plate.vtu eggs.vtu; do [ -s "$file" ] || { echo "-> no $file"; exit 1; }; done
