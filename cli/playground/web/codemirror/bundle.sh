#!/usr/bin/env bash
# bundle.sh: makes codemirror.min.js from CodeMirror of the npm registry. Needs npm; run it after a change of used.js or
# of a version. Nothing of this runs when AF2 is built.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
# Every package is pinned, so that the same script makes the same file.
packages=(@codemirror/autocomplete@6.20.4 @codemirror/commands@6.11.1 @codemirror/language@6.13.1 @codemirror/lint@6.9.8
  @codemirror/search@6.7.2 @codemirror/state@6.7.6 @codemirror/streamparser@6.0.0 @codemirror/view@6.43.15
  @lezer/common@1.5.5 @lezer/highlight@1.2.5 @lezer/lr@1.4.12 @marijn/find-cluster-break@1.0.4
  crelt@1.0.7 style-mod@4.1.5 w3c-keyname@2.2.8)
npm init -y >/dev/null
npm install --no-audit --no-fund "${packages[@]}" esbuild@0.28.2 >/dev/null
cp "$here/used.js" used.js
npx esbuild used.js --bundle --minify --format=iife --global-name=CM --target=es2022 \
  --legal-comments=none --charset=ascii --outfile=codemirror.min.js
{
  for package in "${packages[@]}"; do
    [ -f "node_modules/${package%@*}/LICENSE" ] || { echo "no licence in $package" >&2; exit 1; }
    echo "${package%@*} ${package##*@}"
    echo
    cat "node_modules/${package%@*}/LICENSE"
    echo
  done
} >"$here/LICENSE"
{
  echo "/* CodeMirror 6, MIT licence: cli/playground/web/codemirror/LICENSE */"
  cat codemirror.min.js
} >"$here/codemirror.min.js"
