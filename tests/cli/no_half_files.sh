#!/usr/bin/env bash
# Whatever is at the place of an output stays whole: the old file or the new one, nothing between.
. "$(dirname "$0")/support.sh"

echo old >die.vtu
expect 2 "$af2" mesh "$models/die.step" --size 1 --faces 999 -o die.vtu
[ "$(cat die.vtu)" = old ] || fail "a failed run changed the file"

# Killed at odd moments, the file is the old one or a whole new one.
expect 0 "$af2" mesh "$models/cylinder.step" --size 0.1 -o whole.vtu
for seconds in 0.05 0.1 0.2 0.3 0.4; do
  echo old >killed.vtu
  { timeout -s KILL $seconds "$af2" mesh "$models/cylinder.step" --size 0.1 -o killed.vtu >out 2>err </dev/null; } 2>/dev/null
  [ "$(head -c 4 killed.vtu)" = old ] || cmp -s killed.vtu whole.vtu || fail "half a file after $seconds s"
done

# A disk that fills up. MED, Exodus II and CGNS files are written by libraries of others, if these are there.
if (ulimit -f 64) 2>/dev/null; then
  for format in vtu med exo cgns; do
    echo old >small.$format
    (ulimit -f 64; trap '' XFSZ; exec "$af2" mesh "$models/cylinder.step" --size 0.1 -o small.$format) >out 2>err </dev/null
    [ $? -ne 0 ] || fail "a .$format file that was too large did not matter"
    told "cannot write 'small.$format'"
    [ "$(cat small.$format)" = old ] || fail "half a .$format file after a refused write"
  done
fi

# A file that cannot be written, here because single precision is not enough, does not affect others.
python3 - >far.obj <<'PYTHON'
corners = [(x, y, z) for z in (0, 2) for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))]
for x, y, z in corners: print("v", 1e9 + x, y, z)
for f in ("1 4 3 2", "5 6 7 8", "1 2 6 5", "2 3 7 6", "3 4 8 7", "4 1 5 8"): print("f", f)
PYTHON
echo old >far.stl
expect 1 "$af2" mesh far.obj --size 1 -o far.stl -o far.vtu -o missing.msh --report far.json
told "cannot write an STL file"
[ -s far.vtu ] && [ -s missing.msh ] || fail "the other files were not written"
[ "$(cat far.stl)" = old ] || fail "half a file after a refused format"
[ "$(json far.json status)" = partial ] || fail "the report says nothing of it"
json far.json reason | grep -q 'STL' || fail "the report does not say which file is missing"

# Of a file that is too large only a part is read; it is never written back.
{ echo 'af2 1;'; head -c 9000000 /dev/zero | tr '\0' '#'; echo; echo '# the end'; } >large.af2
expect 1 "$af2" new rule 'corner' --into large.af2; told 'the file is larger than 8 MiB'
[ "$(tail -n 1 large.af2)" = '# the end' ] || fail "a large file was cut off"
[ -z "$(find . -name '*.tmp')" ] || fail "a temporary file is left"
finish
