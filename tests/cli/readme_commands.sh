#!/usr/bin/env bash
# Every command of the README works, in the order in which it stands there. (./check is what runs this.)
. "$(dirname "$0")/support.sh"
source=$2
ln -s "$source/examples" "$source/rules" .
ln -s "$af2" af2

mapfile -t commands < <(grep -E '^(\./af2|cp) ' "$source/README.md" | sed 's/  *#.*//')
[ ${#commands[@]} -ge 4 ] || fail "the README has only ${#commands[@]} commands"
for command in "${commands[@]}"; do
  expect 0 bash -c "$command"
done
finish
