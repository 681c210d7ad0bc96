#!/usr/bin/env bash
# Meshes in parts: together they are the mesh, and each has the ghosts that it should have.
. "$(dirname "$0")/support.sh"

for options in "$models/die.step --size 1" "$models/cylinder.step --size 0.6 --elements quad --order 2" \
  "$models/plate.poly --size 0.3"; do
  expect 0 "$af2" mesh $options -q -o whole.vtu -o whole.msh2
  expect 0 on 3 $options -q --parts parts.pvtu
  expect 0 on 3 $options -q --parts parts.msh
  expect 0 /usr/bin/python3 "$here/parts.py" 3 "$options"
done
# The same parts, whether the mesh is in the memory of the first process, in that of all, or on their disks.
for model in "$models/die.step --size 1" "$models/plate.poly --size 0.015"; do
  expect 0 on 3 $model -q --parts kept.msh
  expect 0 on 3 $model -q --parts whole.msh -o whole.inp
  expect 0 on 3 $model -q --parts disk.msh --stream
  for part in 1 2 3; do
    same kept_$part.msh whole_$part.msh
    same kept_$part.msh disk_$part.msh
  done
done
# Fewer elements than processes.
printf '4 2 0 0\n1 0 0\n2 1 0\n3 1 1\n4 0 1\n4 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n0\n' >square.poly
for i in 1 2 3; do expect 0 on 8 square.poly --size 2 -q --parts few.pvtu; done
# Two have one of the two triangles, and the other one as a ghost.
cells=$(grep -aho 'NumberOfCells="[0-9]*"' few_?.vtu | sort | uniq -c | tr -s ' \n' ' ')
[ "$cells" = ' 6 NumberOfCells="0" 2 NumberOfCells="2" ' ] || fail "other elements in parts: $cells"
# Gmsh reads them one by one; to read all, with ghosts, is more than its version 4.8 can do with its own.
if command -v gmsh >/dev/null; then
  for part in 1 2 3; do
    expect 0 timeout 60 gmsh -0 "parts_$part.msh" -o again.msh
    grep -E "^(Warning|Error)" err && fail "gmsh complains"
  done
fi
finish
