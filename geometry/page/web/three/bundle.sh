#!/usr/bin/env bash
# bundle.sh: makes three.min.js from three.js of the npm registry. Needs npm; run it after a change of used.js or of
# the version. Nothing of this runs when AF2 is built.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm init -y >/dev/null
npm install --no-audit --no-fund three@0.187.0 esbuild@0.28.2 >/dev/null
cp "$here/used.js" used.js
npx esbuild used.js --bundle --minify --format=iife --global-name=THREE --target=es2022 \
  --legal-comments=none --charset=ascii --outfile=three.min.js
cp node_modules/three/LICENSE "$here/LICENSE"
{
  echo "/* three.js 0.187.0, MIT licence: https://github.com/mrdoob/three.js/blob/r187/LICENSE */"
  sed 's#</script#<\\/script#g' three.min.js
} >"$here/three.min.js"
