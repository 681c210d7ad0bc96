#!/usr/bin/env bash
# Volume meshers fill the material of each solid and leave cavities empty. Without TetGen only the
# points in solids and cavities are counted.
. "$(dirname "$0")/support.sh"
parts=$2/tests/cli/models

# tail_of FILE: holes and regions of a .smesh file, after its triangles.
tail_of() {
  awk 'NR == 1 { left = $1; next } left > 0 { --left; next }
       !triangles { triangles = 1; left = $1; next } { print }' "$1"
}

# volumes_by_attribute NAME: of TetGen's tetrahedra, as a list "1:875 2:33".
volumes_by_attribute() {
  awk 'FNR == 1 { next } /^#/ { next }
       FILENAME ~ /node$/ { x[$1] = $2; y[$1] = $3; z[$1] = $4; next }
       { for (i = 0; i < 3; ++i) { a[i] = x[$(i + 3)] - x[$2]; b[i] = y[$(i + 3)] - y[$2]; c[i] = z[$(i + 3)] - z[$2] }
         v = a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) + c[0] * (a[1] * b[2] - a[2] * b[1])
         sum[$6] += (v < 0 ? -v : v) / 6 }
       END { for (r in sum) printf "%s:%g\n", r, sum[r] }' "$1.node" "$1.ele" | sort | tr '\n' ' '
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
  command -v tetgen >/dev/null || return 0
  expect 0 timeout 100 tetgen -pqYA "$model.smesh"
  found=$(volumes_by_attribute "$model.1")
  same_volumes "$found" "$volumes" || fail "$model: volumes are $found"
}

fills box_with_cavity 1 1 "1:875"
fills box_with_bubble 1 1 "1:886.903" --curvature 40
fills ball_in_cavity 1 2 "1:875 2:33.5103" --curvature 50
fills two_boxes 0 2 "1:64 2:18" --imprint
fills bolt_on_plate 0 2 "1:100 2:9.42478" --imprint --curvature 40
"$af2" mesh "$parts/box_with_bubble.brep" -s 1 -j 2 -q -o two.smesh
"$af2" mesh "$parts/box_with_bubble.brep" -s 1 -j 1 -q -o one.smesh
same one.smesh two.smesh
finish
