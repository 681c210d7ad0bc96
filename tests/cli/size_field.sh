#!/usr/bin/env bash
# Sizes from fields that users have: views of Gmsh and arrays of VTK.
. "$(dirname "$0")/support.sh"

# longest_below FILE X: the longest edge of elements of an .obj file whose corners all have x < X
longest_below() {
  awk -v most="$2" '$1 == "v" { ++n; x[n] = $2; y[n] = $3; z[n] = $4 }
    $1 == "f" { for (i = 2; i <= NF; ++i) { a = $i; b = $(i < NF ? i + 1 : 2)
      if (x[a] < most && x[b] < most) {
        d = sqrt((x[a] - x[b]) ^ 2 + (y[a] - y[b]) ^ 2 + (z[a] - z[b]) ^ 2); if (d > longest) longest = d } } }
    END { print longest + 0 }' "$1"
}
within() {  # NUMBER LOW HIGH WHAT
  awk -v n="$1" -v low="$2" -v high="$3" 'BEGIN { exit !(n >= low && n <= high) }' || fail "$4: $1 is not between $2 and $3"
}

# Small at x = 0, large at x = 10.
cat >sizes.pos <<'E'
View "h" {
ST(0,0,0,10,0,0,10,6,0){0.1,1,1};
ST(0,0,0,10,6,0,0,6,0){0.1,1,0.1};
};
E
expect 0 "$af2" mesh "$models/plate.poly" --size 1 --size-field sizes.pos -o plate.obj -o plate.vtu
within "$(longest_below plate.obj 0.3)" 0.07 0.2 "edges at x = 0"
expect 0 "$af2" mesh "$models/plate.poly" --size 1 -o coarse.obj
within "$(longest_below coarse.obj 1.5)" 0.5 1.6 "edges at x = 0 without a field"

# The array that AF2 writes gives nearly the same mesh again; so does the .msh view that meshio writes.
expect 0 "$af2" mesh "$models/plate.poly" --size 1 --size-field plate.vtu:wanted_size -o again.obj
within "$(awk '/^f/' again.obj | wc -l)" "$(awk '/^f/ { ++n } END { print 0.9 * n }' plate.obj)" \
  "$(awk '/^f/ { ++n } END { print 1.1 * n }' plate.obj)" "elements"
if /usr/bin/python3 -c 'import meshio' 2>/dev/null; then
  /usr/bin/python3 -c 'import meshio
mesh = meshio.read("plate.vtu")
for name in ("gmsh", "gmsh22"):
    meshio.write(name + ".msh", meshio.Mesh(mesh.points, [c for c in mesh.cells if c.type == "triangle"],
                 point_data={"h": mesh.point_data["wanted_size"]}), file_format=name)' >/dev/null
  for name in gmsh gmsh22; do
    expect 0 "$af2" mesh "$models/plate.poly" --size 1 --size-field $name.msh -o view.obj
    same again.obj view.obj
  done
fi

# A CAD model, and several fields: the smallest size counts.
printf 'View "h" { SP(0,0,0){0.5}; };' >point.pos
expect 0 "$af2" mesh "$models/cylinder.step" --size 2 --size-field point.pos -o point.obj
expect 0 "$af2" mesh "$models/cylinder.step" --size 0.5 -o same.obj
within "$(grep -c '^f' point.obj)" "$(awk '/^f/ { ++n } END { print 0.9 * n }' same.obj)" \
  "$(awk '/^f/ { ++n } END { print 1.1 * n }' same.obj)" "elements of the cylinder"

for name in sizes.pos:x plate.vtu:x; do
  expect 1 "$af2" mesh "$models/plate.poly" --size 1 --size-field $name -o no.obj
  says_one_line
  told "has no array 'x'; there is"
done
expect 1 "$af2" mesh "$models/plate.poly" --size 1 --size-field none.pos -o no.obj
says_one_line
expect 1 "$af2" mesh "$models/plate.poly" --size 1 --size-field "$models/plate.poly" -o no.obj
told "give an .msh, .pos or .vtu file"
[ ! -e no.obj ] || fail "there is a mesh"
finish
