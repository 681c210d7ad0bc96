#!/usr/bin/env bash
# TetGen, Gmsh and Netgen fill the material of each solid and leave cavities empty. Without them only the
# points in solids and cavities are counted.
. "$(dirname "$0")/support.sh"
parts=$2/tests/cli/models
volumes_geo=$2/examples/volume/volumes.geo
fill_with_netgen=$2/examples/volume/fill_with_netgen.py

# tail_of FILE: holes and regions of a .smesh file, after its triangles.
tail_of() {
  awk 'NR == 1 { left = $1; next } left > 0 { --left; next }
       !triangles { triangles = 1; left = $1; next } { print }' "$1"
}

# volumes_of: of tetrahedra by attribute, as a list "1:875 2:33". Reads lines "v NUMBER X Y Z" and
# "t ATTRIBUTE VERTEX VERTEX VERTEX VERTEX".
volumes_of() {
  awk '$1 == "v" { x[$2] = $3; y[$2] = $4; z[$2] = $5; next }
       { for (i = 0; i < 3; ++i) { a[i] = x[$(i + 4)] - x[$3]; b[i] = y[$(i + 4)] - y[$3]; c[i] = z[$(i + 4)] - z[$3] }
         v = a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) + c[0] * (a[1] * b[2] - a[2] * b[1])
         sum[$2] += (v < 0 ? -v : v) / 6 }
       END { for (r in sum) printf "%s:%g\n", r, sum[r] }' | sort | tr '\n' ' '
}

tetgen_tetrahedra() {
  awk 'FNR == 1 || /^#/ { next }
       FILENAME ~ /node$/ { print "v", $1, $2, $3, $4; next }
       { print "t", $6, $2, $3, $4, $5 }' "$1.node" "$1.ele"
}

# Of a file of format 2.2: type 4 is a tetrahedron; the second of two tags is the volume.
gmsh_tetrahedra() {
  awk '/^\$/ { section = $1; next }
       section == "$Nodes" && NF == 4 { print "v", $0 }
       section == "$Elements" && $2 == 4 { print "t", $5, $6, $7, $8, $9 }' "$1"
}

# same_volumes FOUND WANTED: within half a percent, which the chords of curved faces cost.
same_volumes() {
  awk -v found="$1" -v wanted="$2" 'BEGIN {
    if (split(found, f, /[: ]+/) - 1 != split(wanted, w, /[: ]+/)) exit 1
    for (i in w) if ((f[i] - w[i]) ^ 2 > (i % 2 == 0 ? .005 * w[i] : 0) ^ 2) exit 1 }'
}

# fills MODEL HOLES REGIONS VOLUMES OPTIONS...
fills() {
  local model=$1 holes=$2 regions=$3 volumes=$4 found
  shift 4
  expect 0 "$af2" mesh "$parts/$model.brep" -s 1 "$@" -o "$model.smesh"
  found=$(tail_of "$model.smesh" | awk 'NF == 1' | tr '\n' ' ')
  [ "$found" = "$holes $regions " ] || fail "$model: holes and regions are $found"
  if command -v tetgen >/dev/null; then
    expect 0 timeout 100 tetgen -pqYA "$model.smesh"
    found=$(tetgen_tetrahedra "$model.1" | volumes_of)
    same_volumes "$found" "$volumes" || fail "$model: volumes by TetGen are $found"
  fi
  if command -v gmsh >/dev/null; then
    expect 0 "$af2" mesh "$parts/$model.brep" -s 1 "$@" -o "$model.msh"
    expect 0 timeout 100 gmsh -3 "$model.msh" "$volumes_geo" -format msh22 -o filled.msh
    found=$(gmsh_tetrahedra filled.msh | volumes_of)
    same_volumes "$found" "$volumes" || fail "$model: volumes by Gmsh are $found"
    grep -qE '^3 1 "solid 1 \(volume\)"' filled.msh || fail "$model: the volume has no name"
  fi
  if /usr/bin/python3 -c 'import netgen, numpy' 2>/dev/null; then
    expect 0 "$af2" mesh "$parts/$model.brep" -s 1 "$@" -o "$model.vol"
    expect 0 timeout 100 /usr/bin/python3 "$fill_with_netgen" "$model.vol"
    found=$(awk '/^domain/ { print $2 + 0 ":" $NF }' out | tr '\n' ' ')
    same_volumes "$found" "$volumes" || fail "$model: volumes by Netgen are $found"
  fi
}

fills box_with_cavity 1 1 "1:875"
fills box_with_bubble 1 1 "1:886.903" --curvature 40
fills ball_in_cavity 1 2 "1:875 2:33.5103" --curvature 50
fills two_boxes 0 2 "1:64 2:18" --imprint
parts=$models fills bolt_on_plate 0 2 "1:100 2:9.42478" --imprint --curvature 40

# Groups: an element of MSH 2 is in one.
expect 0 "$af2" mesh "$parts/two_boxes.brep" -s 1 --imprint --groups interfaces,solids -o groups.msh2 -o groups.msh
[ "$(grep -c '^2 .*"' groups.msh2)" = 3 ] || fail "there are not three groups"
grep -q '"solid 1|solid 2"' groups.msh2 || fail "the interface is no group"
grep -q '"face' groups.msh2 && fail "faces are groups though they are in others"
expect 0 "$af2" quality groups.msh2
expect 2 "$af2" mesh "$parts/two_boxes.brep" -s 1 --groups walls -o groups.msh; told "'walls' is no kind of group"
expect 2 "$af2" mesh "$parts/two_boxes.brep" -s 1 --groups parts -o groups.ply; told "--groups is for .msh, .msh2, .stl, .obj, "

# Units.
expect 0 "$af2" mesh "$models/brickhole.step" -s 2 -o plain.obj
expect 0 "$af2" mesh "$models/brickhole.step" -s 2 --unit m -o metres.obj
expect 0 "$af2" mesh "$models/brickhole.step" -s 2 --scale .001 -o scaled.obj
same metres.obj scaled.obj
paste -d' ' plain.obj metres.obj | awk '$1 == "v" { n++; if (($2 / 1000 - $6) ^ 2 > 1e-20) exit 1 } END { exit n < 9 }' ||
  fail "metres are no thousandths"
expect 2 "$af2" mesh "$parts/two_boxes.brep" -s 1 --unit m -o metres.obj; told "does not say its unit"
expect 2 "$af2" mesh "$models/plate.poly" -s 1 --unit m; told "does not say its unit"
expect 2 "$af2" mesh "$models/brickhole.step" -s 2 --unit mile; told "choose one of"
expect 2 "$af2" mesh "$models/brickhole.step" -s 2 --unit m --scale 2; told "exclude each other"
expect 2 "$af2" mesh "$models/brickhole.step" -s 2 --scale -1; told "--scale"

# The same bytes on any number of threads.
"$af2" mesh "$parts/box_with_bubble.brep" -s 1 -j 2 -q -o two.smesh
"$af2" mesh "$parts/box_with_bubble.brep" -s 1 -j 1 -q -o one.smesh
same one.smesh two.smesh
finish
