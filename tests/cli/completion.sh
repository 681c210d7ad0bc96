#!/usr/bin/env bash
# Completion in bash, zsh and fish (those that are installed), and manual pages: of every verb and option.
. "$(dirname "$0")/support.sh"
touch part.step

# gives FILE WORD...: the words are among those that a shell offered in FILE.
gives() {
  local file=$1 word
  shift
  for word; do grep -qwF -- "$word" "$file" || { cp "$file" out; fail "$file lacks '$word'"; }; done
}
# refuses FILE WORD...: they are not.
refuses() {
  local file=$1 word
  shift
  for word; do ! grep -qwF -- "$word" "$file" || { cp "$file" out; fail "$file has '$word'"; }; done
}

# bash: what the function leaves for the last of some words.
"$af2" completion bash >af2.bash
in_bash() {
  bash -c 'source ./af2.bash; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
    compopt() { echo "$*"; }; _af2; printf "%s\n" "${COMPREPLY[@]}"' bash "$@" >offered
}
in_bash af2 me && gives offered mesh && refuses offered draw
in_bash af2 mesh --el && gives offered --elements
in_bash af2 mesh --elements '' && gives offered any quad
in_bash af2 mesh -o '' && gives offered default
in_bash af2 doc -o '' && gives offered dirnames
in_bash af2 mesh --size '' && refuses offered default
in_bash af2 trace '' && gives offered diff view
in_bash af2 trace view --f && gives offered --face && refuses offered --title
in_bash af2 new ru && gives offered ruleset rule

if command -v fish >/dev/null; then
  "$af2" completion fish >af2.fish
  in_fish() { HOME=$work fish -c "source af2.fish; complete -C '$1'" >offered; }
  in_fish 'af2 me' && gives offered mesh && refuses offered draw
  in_fish 'af2 mesh --el' && gives offered --elements
  in_fish 'af2 mesh --elements ' && gives offered any quad && refuses offered part.step
  in_fish 'af2 mesh ' && gives offered part.step
  in_fish 'af2 mesh --size ' && refuses offered part.step
  in_fish 'af2 trace ' && gives offered diff view
  in_fish 'af2 trace view --f' && gives offered --face && refuses offered --title
fi

if command -v zsh >/dev/null; then
  mkdir functions && "$af2" completion zsh >functions/_af2
  # A shell in a terminal, in which one word is typed and Tab is pressed.
  cat >tab.zsh <<'END'
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell 'PS1=; fpath=(./functions $fpath); autoload -U compinit; compinit -u -D; bindkey "^I" complete-word; echo re""ady'
zpty -r -m shell answer '*ready*'
zpty -w -n shell "$1"$'\t'
for ((i = 0; i < 100; ++i)); do
  sleep 0.1
  while zpty -r -t shell more; do answer+=$more; done
  [[ $answer == *$2* ]] && exit 0
done
print -r -- "zsh made of '$1': $answer"
exit 1
END
  expect 0 zsh -f tab.zsh 'af2 mesh --elements q' quad
  expect 0 zsh -f tab.zsh 'af2 trace view --fa' --face
  expect 0 zsh -f tab.zsh 'af2 mesh par' part.step
fi

# Manual pages: one for each verb, each with all options of its help.
expect 0 "$af2" manual -o pages
verbs=$("$af2" --help | sed -n '/^Verbs:/,/^$/s/^  \([a-z-]*\) .*/\1/p')
[ "$(wc -w <<<"$verbs")" -gt 15 ] || fail "af2 --help lists few verbs"
for verb in $verbs; do
  grep -qF "af2\\-${verb//-/\\-}" pages/af2.1 || fail "af2.1 lacks $verb"
  "$af2" "$verb" --help | grep -oE '^  (-[a-z],)?--[a-z-]+' | sed 's/.*--/--/' | sed 's/-/\\-/g' >wanted
  while read -r option; do
    grep -qF -- "$option\\fR" "pages/af2-$verb.1" || fail "af2-$verb.1 lacks $option"
  done <wanted
  expect 0 "$af2" manual "$verb"
  same out "pages/af2-$verb.1"
done
if command -v man >/dev/null; then
  for page in pages/*.1; do
    LC_ALL=C.UTF-8 MANROFFSEQ='' man --warnings -E UTF-8 -l -Tutf8 -Z "$page" 2>&1 >/dev/null | tee warnings | head -3
    [ ! -s warnings ] || fail "man warns of $page"
  done
fi
expect 2 "$af2" manual mash
told "'mash' is not a verb of af2"
expect 2 "$af2" completion tcsh
told "choose one of bash, zsh, fish"
finish
