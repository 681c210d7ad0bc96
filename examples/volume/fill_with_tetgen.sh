#!/usr/bin/env bash
# From a CAD model to tetrahedra by TetGen: fill_with_tetgen.sh AF2 MODEL SIZE OUTPUT
# writes OUTPUT.smesh, the surface, and OUTPUT.1.node, .ele and so on. Debian's package tetgen is needed.
set -euo pipefail
af2=$1 model=$2 size=$3 output=$4
"$af2" mesh "$model" --size "$size" -o "$output.smesh"
# p: keep the surface; q: tetrahedra of good quality; Y: no new vertices on the surface.
tetgen -pqY "$output.smesh"
