#!/usr/bin/env bash
# Meshes in parts: together they are the mesh, and each has the ghosts that it should have.
. "$(dirname "$0")/support.sh"

for options in "$models/die.step --size 1" "$models/cylinder.step --size 0.6 --elements quad --order 2" \
  "$models/plate.poly --size 0.3"; do
  expect 0 "$af2" mesh $options -q -o whole.vtu -o whole.msh
  expect 0 on 3 $options -q --parts parts.pvtu
  expect 0 on 3 $options -q --parts parts.msh
  expect 0 /usr/bin/python3 "$here/parts.py" 3 "$options"
done
if command -v gmsh >/dev/null; then
  expect 0 timeout 60 gmsh -0 parts_2.msh -o again.msh
fi
finish
