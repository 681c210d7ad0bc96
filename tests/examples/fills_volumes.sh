#!/usr/bin/env bash
# fills_volumes.sh AF2 SOURCE: TetGen and Netgen take the meshes of the examples, also of models that
# are given as triangles, and fill them with tetrahedra, and leave the triangles as they are. Exit
# code 77: neither is installed.
set -euo pipefail
af2=$1 source=$2
examples=$source/examples/volume models=$source/examples/models
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
done_any=
fail() { echo "FAILED: $*"; exit 1; }

fill_with_tetgen() {
  local model=$1 size=$2 volume=$3
  "$examples/fill_with_tetgen.sh" "$af2" "$model" "$size" "$folder/filled" >"$folder/log" ||
    { cat "$folder/log"; fail "TetGen on $model"; }
  /usr/bin/python3 - "$folder/filled" "$volume" <<'PYTHON' || fail "tetrahedra of $model"
import sys

name, wanted = sys.argv[1], float(sys.argv[2])
def rows(file):
    lines = [line.split() for line in open(file) if line.strip() and not line.startswith("#")]
    return int(lines[0][0]), lines[1:]

points = {int(r[0]): [float(x) for x in r[1:4]] for r in rows(name + ".1.node")[1]}
count, tetrahedra = rows(name + ".1.ele")
def volume(p, q, r, s):
    (a, b, c), (d, e, f), (g, h, i) = ([y - x for x, y in zip(p, z)] for z in (q, r, s))
    return abs(a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)) / 6
total = sum(volume(*(points[int(v)] for v in row[1:5])) for row in tetrahedra)
assert abs(total - wanted) < 0.05 * wanted, f"volume {total}, should be {wanted}"

lines = [line.split() for line in open(name + ".smesh")]
vertices, triangles = int(lines[0][0]), int(lines[1 + int(lines[0][0])][0])
boundary = rows(name + ".1.face")[0]
assert boundary == triangles, f"{boundary} triangles instead of {triangles}"
for row in lines[1:1 + vertices]:
    assert points[int(row[0])] == [float(x) for x in row[1:4]], "a vertex was moved"
PYTHON
}

"$af2" mesh "$models/cylinder.step" --size 1 -o "$folder/cylinder.stl" --quiet
"$af2" mesh "$models/brickhole.step" --size 1 -o "$folder/brickhole.obj" --quiet
if command -v tetgen >/dev/null; then
  fill_with_tetgen "$models/brickhole.step" 2 840
  fill_with_tetgen "$models/cylinder.step" 2 785.4
  fill_with_tetgen "$folder/cylinder.stl" 2 785.4
  fill_with_tetgen "$folder/brickhole.obj" 2 840
  done_any=yes
fi
if /usr/bin/python3 -c 'import netgen.meshing, meshio' 2>/dev/null; then
  for model in "$models/brickhole.step" "$folder/brickhole.obj"; do
    "$af2" mesh "$model" --size 2 -o "$folder/brick.vol" --quiet
    /usr/bin/python3 "$examples/fill_with_netgen.py" "$folder/brick.vol" "$folder/filled.vtu" >"$folder/log" ||
      { cat "$folder/log"; fail "Netgen on $model"; }
    grep -q 'volume 840' "$folder/log" || fail "Netgen filled something else: $(tail -1 "$folder/log")"
  done
  done_any=yes
fi
[ -n "$done_any" ] || { echo "neither tetgen nor python3-netgen is installed"; exit 77; }
