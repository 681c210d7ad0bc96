#!/usr/bin/env bash
# read_with_meshio.sh PROGRAM: lets PROGRAM write the cube in every format and reads it with meshio.
# Debian's Python has Debian's meshio. Exit code 77: there is no meshio.
set -euo pipefail
python=/usr/bin/python3
$python -c 'import meshio' 2>/dev/null || { echo "no meshio for $python"; exit 77; }
directory=$(mktemp -d)
trap 'rm -rf "$directory"' EXIT
"$1" "$directory"
$python "$(dirname "$0")/read_with_meshio.py" "$directory"
