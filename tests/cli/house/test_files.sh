#!/usr/bin/env bash
# test_files.sh SOURCE: tests run at the same time, so each has a folder of its own for its files.
set -euo pipefail
cd "$1/tests"
shared=$(grep -rnE '(temp_directory_path\(\)|TempDir\(\)\)) */' --include='*.cpp' --include='*.h' . |
  grep -v '^\./support/test_folder\.h:' || true)
[ -z "$shared" ] || { printf 'use TestFolder or TestFile (tests/support/test_folder.h):\n%s\n' "$shared"; exit 1; }
