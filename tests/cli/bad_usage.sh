#!/usr/bin/env bash
# What cannot be done is told in one line with the way out, and leaves no file behind.
. "$(dirname "$0")/support.sh"
cylinder=$models/cylinder.step

usage() { expect 2 "$@"; says_one_line; }
unusable() { expect 1 "$@"; says_one_line; }

usage "$af2"; told 'a verb is missing; the verbs are: mesh,'
usage "$af2" mash "$cylinder"; told "'mash' is not a verb of af2"
usage "$af2" mesh; told 'MODEL is required'
usage "$af2" mesh "$cylinder"; told '--size is required'
for size in 0 -1 nan inf 1mm; do
  usage "$af2" mesh "$cylinder" "--size=$size"; told 'greater than 0'
done
usage "$af2" mesh "$cylinder" --size=; told '--size'
usage "$af2" mesh "$cylinder" --size=1,5; told 'such as 1.5'
usage "$af2" mesh "$cylinder" --fewest; told '--fewest needs --chord'
usage "$af2" mesh "$cylinder" --fewest --chord 5%; told 'a share of the size needs --size'
usage "$af2" mesh "$cylinder" --size 1 --chord=-1; told 'greater than 0'
usage "$af2" mesh "$cylinder" --size 1 --chord 0%; told 'greater than 0'
usage "$af2" mesh "$cylinder" --size 1 --face-chord 3; told 'write ids'
usage "$af2" mesh "$cylinder" --size 1 --face-chord 99=1; told 'there is no face 99'
usage "$af2" mesh "$cylinder" --fewest --chord 1 --order 2; told 'triangles of order 1'
usage "$af2" mesh "$cylinder" --size 1 --curvature 200deg; told 'at least 3 elements'
usage "$af2" mesh "$cylinder" --size 1 --periodic w; told 'write x, y, z, or the ids of two faces'
usage "$af2" mesh "$cylinder" --size 1 --periodic 1-2=3; told 'one face on each side'
usage "$af2" mesh "$cylinder" --size 1 --periodic z --faces 1; told 'cannot be combined'
usage "$af2" mesh "$models/plate.poly" --size 1 --periodic x; told '--periodic is for'
unusable "$af2" mesh "$cylinder" --size 1 --periodic 1=2; told 'are not periodic: their areas are'
unusable "$af2" mesh "$cylinder" --size 1 --periodic 1=9; told 'there is no face 9'
echo '{"points": [[0, 0, 77]]}' >far.json
unusable "$af2" mesh "$cylinder" --size 1 --points far.json; told 'it is on no face of the model'
unusable "$af2" mesh "$models/plate.poly" --size 1 --points far.json; told 'in the plane z = 0'
usage "$af2" mesh "$cylinder" --size; told '--size: its value is missing'
usage "$af2" mesh "$cylinder" --size 1 --faces ''; told '--faces: its value is empty'
usage "$af2" mesh "$cylinder" --size 1 --chart=; told '--chart'
usage "$af2" mesh "$cylinder" --size 1 --size 2; told '--size is given 2 times'
usage "$af2" mesh --size 1 -- -- a; told "unexpected argument 'a'"
expect 1 "$af2" mesh --size 1 -- -x.step; told "there is no file '-x.step'"
usage "$af2" mesh "$cylinder" --size 1 --sise 2; told "unknown option '--sise'; did you mean '--size'?"
usage "$af2" mesh "$cylinder" --sise=2; told "unknown option '--sise'; did you mean '--size'?"
usage "$af2" mesh "$cylinder" --size 1 -z; told "unknown option '-z'"
usage "$af2" mesh "$cylinder" two.step --size 1; told "unexpected argument 'two.step'"
usage "$af2" mesh "$cylinder" --size 1 -o a.svg; told 'planar domains only; use .png or .html'
usage "$af2" mesh "$cylinder" --size 1 --faces 0; told 'counted from 1'
usage "$af2" mesh "$cylinder" --size 1 --faces 99; told 'there is no face 99; the model has faces 1 to 3'
usage "$af2" mesh "$cylinder" --size 1 --edge-size 99=0.1; told 'there is no edge 99'
usage "$af2" mesh "$cylinder" --size 1 --face-size 1; told '3,7-9=0.1'
usage "$af2" mesh "$cylinder" --size 1 --curvature 2; told 'at least 3'
usage "$af2" mesh "$cylinder" --size 1 --min-size 2 --max-size 1; told 'above --max-size'
usage "$af2" mesh "$cylinder" --size 1 --grading 0; told '--grading'
usage "$af2" mesh "$cylinder" --size 1 --grading 1000; told 'at most 10 per unit of length'
unusable "$af2" mesh "$cylinder" --size 1 -r quad; told 'AF2 has quad/classic.af2, '
unusable "$af2" mesh "$cylinder" --size 1 --sizes nothing.json; told 'nothing.json'
echo '{"parts": {"nowhere": 1}}' >sizes.json
unusable "$af2" mesh "$cylinder" --size 1 --sizes sizes.json; told "no face or group has such a name"
usage "$af2" mesh "$cylinder" --size 1 --feature-angle 20; told 'is for STL, OBJ, '
usage "$af2" mesh "$cylinder" --size 1 --chart round; told "choose one of auto, mean-normal"
echo 'v 0 0 x' >bad.obj
usage "$af2" mesh "$models/plate.poly" --size 1 --chart auto; told 'curved faces'
usage "$af2" mesh "$models/plate.poly" --size 1 --faces 99; told 'there is no face 99'
usage "$af2" mesh "$models/plate.poly" --size 1 --edge-size 99=1; told 'there is no edge 99'
usage "$af2" inspect "$models/plate.poly" --heal; told 'STEP, IGES and BREP'
unusable "$af2" mesh bad.obj --size 1; told "'x' is not a number"
usage "$af2" mesh "$cylinder" --size 1 --heal-tolerance 1; told 'needs --heal'
usage "$af2" mesh "$models/plate.poly" --size 1 --heal; told 'STEP, IGES and BREP'
usage "$af2" mesh "$cylinder" --size 1 --order 3; told 'order 1 or 2'
usage "$af2" mesh "$cylinder" --size 1 --order 2 -o a.stl; told 'cannot hold elements of order 2'
usage "$af2" mesh "$cylinder" --size 1 --threads -1; told '--threads'
usage "$af2" mesh "$cylinder" --size 1 --threads two; told "--threads 'two': give a whole number"
unusable "$af2" mesh "$cylinder" --size 1e-300; told 'need more than'
unusable "$af2" mesh "$cylinder" --size 0.005 --max-memory 200M; told 'allowed; ask for sizes that are at least'
expect 0 "$af2" mesh "$cylinder" --size 0.005 --max-memory 1M --coarsen --report coarse.json
grep -q 'need too much memory: all are [0-9.]* times as large' out || fail "--coarsen does not say how much larger sizes are"
[ "$(json coarse.json triangles)" -lt 12000 ] || fail "--coarsen makes more elements than fit"
[ "$(json coarse.json triangles)" -gt 5000 ] || fail "--coarsen makes far fewer elements than fit"
(ulimit -v 2000000 && "$af2" mesh "$cylinder" --size 0.005) >out 2>err && fail 'exit code 0 without the memory'
told 'are free; ask for sizes that are at least'
usage "$af2" mesh "$cylinder" --size 1 -o mesh.xyz; told '.vtu'
usage "$af2" mesh "$cylinder" --size 1 -o mesh; told '.vtu'
usage "$af2" mesh "$cylinder" --size 1 -o nowhere/a.vtu; told "mkdir -p"
usage "$af2" mesh "$cylinder" --size 1 -o a.vtu -o ./a.vtu; told 'twice'
mkdir folder.vtu
usage "$af2" mesh "$cylinder" --size 1 -o folder.vtu; told 'it is a directory'
usage "$af2" mesh "$cylinder" --size 1 --report nowhere/r.json; told 'mkdir -p'
long=$(printf 'a%.0s' {1..300})
usage "$af2" mesh "$cylinder" --size 1 -o $long.vtu; told 'its name is too long'
usage "$af2" mesh "$cylinder" --size 1 -o ${long:0:250}.vtu; told 'its name is too long'
unusable "$af2" mesh $long --size 1; told 'there is no file'
unusable "$af2" mesh "$cylinder" --size 1 --sizes $long; told 'cannot be opened'
unusable "$af2" inspect $long; told "$long"
ln -s turn.vtu turn.vtu
usage "$af2" mesh "$cylinder" --size 1 -o turn.vtu; told 'link to itself'
rm turn.vtu
unusable "$af2" mesh /dev/null --size 1; told 'not a regular file'
echo '{"points": [{"at": [1e999, 0, 0], "size": 1}]}' >sizes.json
unusable "$af2" mesh "$cylinder" --size 1 --sizes sizes.json; told 'sizes.json'

unusable "$af2" mesh nothing.step --size 1; told "there is no file 'nothing.step'"
unusable "$af2" mesh . --size 1; told 'is a directory'
unusable "$af2" mesh - --size 1; told 'standard input is empty; pipe a model into it'
gzip -c "$cylinder" >packed.step.gz
unusable "$af2" mesh packed.step.gz --size 1; told 'unpack it first'
unusable "$af2" mesh "$cylinder" --size 1 -r nothing.af2; told "there is no rule file 'nothing.af2'"
unusable "$af2" mesh "$cylinder" --size 1 -r "$models"; told 'is a directory'
usage "$af2" inspect "$cylinder" --picture a.jpg; told '.svg nor .png'
usage "$af2" inspect "$cylinder" --size 0; told 'greater than 0'
unusable "$af2" inspect nothing.step; told 'nothing.step'
unusable env AF2_RULES=/nowhere "$af2" mesh "$cylinder" --size 1; told 'AF2_RULES'
: >empty.step
unusable "$af2" mesh empty.step --size 1 --report empty.json; told 'empty.step'
[ "$(json empty.json status)" = failed ] || fail "no report of an empty file"
if [ -w /dev/full ]; then
  expect 1 bash -c '"$@" >/dev/full' - "$af2" inspect "$cylinder"; told 'cannot write all of the output'
  expect 1 bash -c '"$@" >/dev/full' - "$af2" fmt "$2/rules/tri/classic.af2"; told 'cannot write all of the output'
fi
head -c 3000 "$cylinder" >cut.step
unusable "$af2" mesh cut.step --size 1; told 'cut.step'
sed 's/CYLINDRICAL_SURFACE/SPIRAL_SURFACE/' "$cylinder" >lost.step
for stream in 1 2; do  # nobody listens
  expect 1 bash -c "exec $stream>&-; exec \"\$@\"" - "$af2" mesh nothing.step --size 1
  expect 3 bash -c "exec $stream>&-; exec \"\$@\"" - "$af2" mesh lost.step --size 1
done
expect 3 "$af2" mesh lost.step --size 1 --report lost.json; told 'could not be read'
[ "$(json lost.json status)" = partial ] || fail "a face is lost, and the status is complete"
expect 0 "$af2" inspect lost.step
grep -q 'could not be read' out || fail "inspect does not tell of a lost face"
head -c 5000 /dev/urandom >noise.brep
unusable "$af2" mesh noise.brep --size 1; told 'noise.brep'
echo 'no mesh at all' >text.igs
unusable "$af2" mesh text.igs --size 1; told 'text.igs'
echo 'rule "broken" {' >broken.af2
expect 1 "$af2" mesh "$cylinder" --size 1 -r broken.af2; told 'broken.af2:1'

if [ "$(id -u)" -ne 0 ]; then
  mkdir locked && chmod a-w locked
  usage "$af2" mesh "$cylinder" --size 1 -o locked/a.vtu; told 'no permission'
fi

expect 0 "$af2" --help
expect 0 "$af2" mesh --help
expect 0 "$af2" --version
expect 0 "$af2" version
expect 0 "$af2" version --json
python3 -m json.tool <out >/dev/null || fail 'version --json is no JSON'

rm -f out err
left=$(find . -name '*.vtu' -type f -o -name '*.tmp')
[ -z "$left" ] || fail "left behind: $left"
finish
