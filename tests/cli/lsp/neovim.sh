#!/usr/bin/env bash
# neovim.sh AF2 SOURCE: the server in a real editor: Neovim edits a file and asks for everything.
set -euo pipefail
af2=$1 source=$2
here=$(cd "$(dirname "$0")" && pwd)
command -v nvim >/dev/null || { echo "neovim is missing; it is in packages.txt"; exit 1; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export HOME=$work XDG_CONFIG_HOME=$work/config XDG_DATA_HOME=$work/data XDG_STATE_HOME=$work/state
export XDG_CACHE_HOME=$work/cache XDG_RUNTIME_DIR=$work/run TMPDIR=$work
mkdir -p config data state cache run
cat >lib.af2 <<'END'
af2 1;

## Half of it.
const HALF = 0.5;
END
cat >rules.af2 <<'END'
af2 1;

import "lib.af2" as lib;

## The height of the ideal triangle.
const H = 0.866;

ruleset "good" {
  elements tri;
}

## Nothing near: the ideal apex.
rule "free" quality 1 {
  let  m = mid(a, b);
  new  c = m + (0, H * 2 * lib.HALF);
  zone a, b, c;
  tri  a b c;
}

test "a lonely edge" {
  front  p (0, 0) -> r (1, 0);
  expect rule "free";
}
END
timeout 60 nvim --headless --clean -n --cmd "let g:af2 = '$af2'" -c "luafile $here/neovim.lua" >log 2>&1 ||
  { echo "Neovim failed:"; cat log; exit 1; }
grep -q '^all is well' log || { cat log; exit 1; }
grep -c '^ok' log
