#!/bin/bash
# make_models makes a model of almost every family.
set -euo pipefail
program=$1
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$program" "$folder/new/models" 1 | tee "$folder/told"
empty=$(grep -c ' 0$' "$folder/told" || true)
if [ "$empty" -gt 3 ]; then
  echo "$empty families made no model"
  exit 1
fi
