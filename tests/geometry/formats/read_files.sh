#!/usr/bin/env bash
# read_files.sh PROGRAM SCRIPT: lets PROGRAM write the cube in every format, and runs SCRIPT, which reads it with
# another program. Debian's Python has Debian's meshio and VTK. Exit code 77: that program is not there.
set -euo pipefail
python=/usr/bin/python3
$python -c 'import meshio' 2>/dev/null || { echo "no meshio for $python"; exit 77; }
directory=$(mktemp -d)
trap 'rm -rf "$directory"' EXIT
"$1" "$directory"
$python "$(dirname "$0")/$2" "$directory"
