#!/usr/bin/env bash
# top_level.sh SOURCE: the top folder holds what belongs there, and nothing that was left behind.
set -euo pipefail
cd "$1"
git rev-parse --is-inside-work-tree >/dev/null 2>&1 || { echo "no git repository"; exit 77; }
others=$(git ls-files | cut -d/ -f1 | sort -u | grep -vxE \
  '\.(ci|clang-format|clang-tidy|gitignore)|CMake(Lists\.txt|Presets\.json)|COPYING|LICENSE|NOTICE|README\.md|packages\.txt|pyproject\.toml|af2|check|cli|docs|dsl|engine|examples|geometry|python|rules|tests' || true)
[ -z "$others" ] || { printf 'does not belong into the top folder:\n%s\n' "$others"; exit 1; }
