#!/usr/bin/env bash
# cgal_licences.sh SOURCE BUILD: no CGAL header that was compiled into AF2 is under the GPL alone.
set -euo pipefail
cd "$2"
command -v ninja >/dev/null || { echo "no ninja"; exit 77; }
[ -f build.ninja ] || { echo "not built with ninja"; exit 77; }

# The dependencies that the compiler told ninja of.
mapfile -t headers < <(ninja -t deps | sed -n 's|^ *\(/.*/CGAL/.*\.h\)$|\1|p' | sort -u)
[ ${#headers[@]} -gt 0 ] || { echo "no CGAL header in the dependencies: built at all?"; exit 1; }
echo "${#headers[@]} headers of CGAL"

# GPL headers say so in their SPDX line and check the licence of the package.
gpl=$(grep -lE 'SPDX-License-Identifier: (GPL|AGPL)' "${headers[@]}" || true)
[ -z "$gpl" ] || { printf 'under the GPL:\n%s\n' "$gpl"; exit 1; }
