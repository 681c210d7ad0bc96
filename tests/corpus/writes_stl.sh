#!/bin/bash
# write_stl writes a model as triangles, which are meshed as the model is.
set -euo pipefail
af2=$1 write_stl=$2 model=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$write_stl" "$model" "$folder/model.stl"
"$af2" mesh "$folder/model.stl" --size 2 -q -o "$folder/mesh.vtu"

if "$write_stl" "$folder/no_such.step" "$folder/nothing.stl" 2> "$folder/told"; then
  echo "a missing model was written"
  exit 1
fi
grep -q no_such.step "$folder/told"
