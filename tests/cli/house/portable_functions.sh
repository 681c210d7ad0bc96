#!/usr/bin/env bash
# portable_functions.sh SOURCE: meshes depend on no function that the C library rounds as the machine likes.
set -euo pipefail
cd "$1"
name='(a?(sin|cos|tan)h?|atan2|exp[2m]?1?|log[12]?p?|pow|cbrt|hypot|sincos)'
used=$(grep -rnE "\bstd::$name\(" --include='*.cpp' --include='*.h' engine dsl geometry || true)
[ -z "$used" ] || { printf 'use engine/base/elementary.h:\n%s\n' "$used"; exit 1; }
