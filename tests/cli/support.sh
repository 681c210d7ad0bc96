# For the scripts of this folder: SCRIPT PROGRAM SOURCE. Gives $af2, $models, a folder $work that goes
# away, and the ways to say what is expected.
set -uo pipefail
af2=$1
models=$2/examples/models
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
cd "$work"
failures=0

# expect CODE COMMAND...: runs COMMAND; its output goes to the files out and err.
expect() {
  local wanted=$1 code=0
  shift
  "$@" >out 2>err </dev/null || code=$?
  [ "$code" -eq "$wanted" ] && return 0
  fail "exit code $code, expected $wanted: $*"
}

# told TEXT: the last command said TEXT on stderr.
told() {
  grep -qF -- "$1" err || fail "stderr lacks '$1'"
}

# says_one_line: errors are one line, and perhaps one more with a hint.
says_one_line() {
  [ "$(grep -vc '^try: ' err)" -eq 1 ] || fail "stderr is not one line"
}

fail() {
  echo "FAILED: $*"
  sed 's/^/    out: /' out 2>/dev/null
  sed 's/^/    err: /' err 2>/dev/null
  failures=$((failures + 1))
}

# same FILE FILE
same() {
  cmp -s "$1" "$2" || fail "$1 and $2 differ"
}

# json FILE PATH...: a value of a report, e.g. json r.json quality min
json() {
  local file=$1
  shift
  python3 -c 'import json, sys
value = json.load(open(sys.argv[1]))
for key in sys.argv[2:]: value = value[int(key) if isinstance(value, list) else key]
print(value)' "$file" "$@"
}

finish() {
  [ "$failures" -eq 0 ] || { echo "$failures failures"; exit 1; }
  echo "all as expected"
}
