#!/usr/bin/env bash
# build_progress.sh AF2 SOURCE: what ./af2 says of the progress of apt-get and ninja, from their output.
set -euo pipefail
root=$2
. "$root/.ci/build.sh"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# expect TEXT LOG: how_far says TEXT of the log, and writes nothing else.
expect() {
  local said
  said=$(how_far <(printf '%b' "$2"))
  [ "$said" = "$1" ] || { echo "expected '$1', got '$said'"; exit 1; }
  [ -z "$(ls)" ] || { echo "left files: $(ls)"; exit 1; }
}

apt='0 upgraded, 4 newly installed, 0 to remove and 0 not upgraded.\n'
expect '' 'Reading package lists...\n'
expect 'downloaded 50 %' "${apt}Get:1 one\nGet:2 two\n"
expect 'unpacked 20 %' "${apt}Get:1 a\nGet:2 b\nGet:3 c\nGet:4 d\nUnpacking a ...\n"
expect 'set up 100 %' "${apt}Setting up a\nSetting up b\nSetting up c\nSetting up d\nSetting up e\n"
expect 'compiled 30 %' '[1/9] a\n[2/9] b\nwarning\n[3/9] c\n'
