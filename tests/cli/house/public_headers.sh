#!/usr/bin/env bash
# public_headers.sh SOURCE BUILD: docs/embedding.md names every public header, and no other one.
set -euo pipefail
source=$1 build=$2
sort -u <(sed -n 's#.*=af2/[a-z]*/\(.*\.h\)$#\1#p' "$build/public_headers.txt") >"$build/installed_headers"
sed -n '/^## The headers/,/^## Changes/p' "$source/docs/embedding.md" | grep -oE '`[a-z0-9_]+\.h`' | tr -d '`' |
  sort -u >"$build/documented_headers"
# Those of af2-mpi are installed where MPI is.
grep -q '=af2/mpi/' "$build/public_headers.txt" || sed -i '/^crew.h$/d; /^owned_part.h$/d' "$build/documented_headers"
diff "$build/installed_headers" "$build/documented_headers" ||
  { echo '< public, but not in docs/embedding.md; > the other way round'; exit 1; }
