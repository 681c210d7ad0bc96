#!/usr/bin/env bash
# include_directions.sh SOURCE: no room includes what it must not know (docs/architecture.md).
set -euo pipefail
cd "$1"
failed=0

# forbid PATTERN WHY FILE...: no #include that matches PATTERN in the files.
forbid() {
  local pattern=$1 why=$2
  shift 2
  [ $# -gt 0 ] || return 0
  if grep -nE "^[[:space:]]*#[[:space:]]*include[[:space:]]*$pattern" "$@" /dev/null; then
    echo "-> $why"
    failed=1
  fi
}

# files FOLDER... [:(exclude)FILE...]: sources of the repository.
mapfile -t all < <(find engine dsl geometry cli -name '*.cpp' -o -name '*.h' | sort)
in_room() { printf '%s\n' "${all[@]}" | grep -E "^$1" || true; }
except() { grep -vxE "$1" || true; }

cad_header='<((BRep|TopoDS|TopExp|TopAbs|TopLoc|TopTools|Geom|GProp|gp_|gp\.|STEP|IGES|XCAF|XSControl|TDoc|TDF|TCol|Standard|Shape|Bnd|Precision|ElSLib|ElCLib|Poly_|Message|Interface|Quantity|NCollection|Adaptor|Extrema|CPnts|GC|OSD|TColStd|BinTools)[A-Za-z0-9_]*\.hxx)>'

mapfile -t engine < <(in_room engine/)
mapfile -t dsl < <(in_room dsl/)
mapfile -t geometry < <(in_room geometry/)
mapfile -t libraries < <(in_room '(engine|dsl|geometry)/')
mapfile -t not_grammar < <(printf '%s\n' "${all[@]}" | except 'dsl/(grammar\.cpp|token_parsers\.h)')
mapfile -t not_occ < <(printf '%s\n' "${all[@]}" | except 'geometry/occ/.*')
mapfile -t not_exact < <(printf '%s\n' "${all[@]}" |
  except 'engine/predicates\.cpp|dsl/shapes/exact\.(h|cpp)')
mapfile -t not_sparse < <(printf '%s\n' "${all[@]}" | except 'geometry/faceted/sparse_system\.cpp')
mapfile -t public < <(in_room '.*\.h$')

forbid '"(dsl|geometry|cli)/' 'the engine knows neither rules as text nor geometry' "${engine[@]}"
forbid '"(geometry|cli)/' 'dsl knows only the engine' "${dsl[@]}"
forbid '"(dsl|cli)/' 'geometry knows only the engine' "${geometry[@]}"
forbid '"geometry/occ/' 'only geometry/occ and cli know OpenCASCADE models' \
  $(printf '%s\n' "${geometry[@]}" | except 'geometry/occ/.*')
forbid '<boost/spirit' 'Boost.Spirit belongs into dsl/grammar.cpp and dsl/token_parsers.h' "${not_grammar[@]}"
forbid '<CGAL/' 'CGAL belongs into engine/predicates.cpp and dsl/shapes/exact.h' "${not_exact[@]}"
forbid '<Eigen/' 'Eigen belongs into geometry/faceted/sparse_system.cpp' "${not_sparse[@]}"
forbid "$cad_header" 'OpenCASCADE belongs into geometry/occ' "${not_occ[@]}"
forbid '<(tbb|oneapi)/' 'no TBB type in a header' "${public[@]}"
# read_model.cpp keeps OpenCASCADE from talking, and must name the streams for that.
mapfile -t silent < <(printf '%s\n' "${libraries[@]}" | except 'geometry/occ/read_model\.cpp')
forbid '<(iostream|CLI/)' 'a library does not talk to the terminal' "${silent[@]}"

exit $failed
