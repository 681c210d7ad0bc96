#!/usr/bin/env bash
# format.sh SOURCE: every tracked file is laid out as .clang-format says.
set -euo pipefail
cd "$1"
command -v clang-format >/dev/null || { echo "no clang-format"; exit 77; }
git rev-parse --is-inside-work-tree >/dev/null 2>&1 || { echo "no git repository"; exit 77; }
git ls-files -z '*.cpp' '*.h' | xargs -0 clang-format --dry-run -Werror
