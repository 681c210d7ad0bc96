#!/usr/bin/env bash
# vscode.sh AF2 SOURCE: the extension for VS Code, in a stand-in for the editor that talks to the real program.
set -euo pipefail
command -v node >/dev/null || { echo "no node"; exit 77; }
extension=$2/examples/vscode-af2
for script in "$extension"/*.js; do node --check "$script"; done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
exec timeout 120 node "$(dirname "$0")/extension_test.js" "$1" "$extension" "$work"
