#!/usr/bin/env bash
# af2 inspect --json and --labels: exact numbers, and what cannot be combined; names instead of numbers.
. "$(dirname "$0")/support.sh"

expect 0 "$af2" inspect "$models/cylinder.step" --json
cp out cylinder.json
python3 - <<'PYTHON' || fail "the numbers of the cylinder"
import json, math
model = json.load(open("cylinder.json"))
wall, *lids = model["faces"]
near = lambda a, b: abs(a - b) < 1e-9 * max(1, abs(b))
assert wall["surface"] == "cylinder" and near(wall["area"], 2 * math.pi * 5 * 10), wall
assert near(wall["curvature"]["min"], 0.2) and near(wall["curvature"]["max"], 0.2), wall
assert wall["neighbors"] == [2, 3] and wall["solids"] == [1], wall
assert sorted(round(lid["centroid"][2], 9) for lid in lids) == [0, 10], lids
assert all(near(lid["area"], math.pi * 25) and lid["curvature"]["max"] == 0 for lid in lids), lids
(solid,) = model["solids"]
assert near(solid["volume"], math.pi * 250) and solid["faces"] == [1, 2, 3], solid
assert near(max(edge["length"] for edge in model["edges"]), 2 * math.pi * 5), model["edges"]
assert model["unit"] == "mm" and model["groups"][-1] == {"kind": "solid", "name": "1", "faces": [1, 2, 3]}
PYTHON

expect 0 "$af2" inspect "$models/die.step" --json
cp out die.json
python3 - <<'PYTHON' || fail "the numbers of the die"
import json
model = json.load(open("die.json"))
faces = {face["id"]: face for face in model["faces"]}
assert len(faces) == 68
for face in faces.values():
    assert all(face["id"] in faces[other]["neighbors"] for other in face["neighbors"]), face
    assert all(low <= high for low, high in zip(face["box"]["low"], face["box"]["high"])), face
for edge in model["edges"]:
    assert all(edge["id"] in faces[face]["edges"] for face in edge["faces"]), edge
PYTHON

expect 0 "$af2" inspect "$models/die.step" --json --merge --size 2 --picture merged.svg
cp out merging.json
[ -s merged.svg ] || fail "there is no picture of what is merged"
expect 0 "$af2" mesh "$models/die.step" --merge --size 2 -o die.vtu --report report.json
python3 - <<'PYTHON' || fail "what would be merged is not what is merged"
import json
merging = json.load(open("merging.json"))["merging"]
assert merging.pop("size") == 2 and merging["groups"], merging
merged = json.load(open("report.json"))["merging"]
for group in merged["groups"]:
    assert group.pop("deviation") >= 0, group
assert merging == merged, (merging, merged)
PYTHON
expect 2 "$af2" inspect "$models/die.step" --json --size 2; told 'add --merge'

expect 0 "$af2" inspect "$models/cylinder.step" --picture plain.svg
expect 0 "$af2" inspect "$models/cylinder.step" --picture labelled.svg --labels
[ "$(wc -c <labelled.svg)" -gt "$(wc -c <plain.svg)" ] || fail "there are no labels on the picture"
expect 2 "$af2" inspect "$models/cylinder.step" --labels; told '--labels needs --picture'
expect 2 "$af2" inspect "$models/cylinder.step" --json --edges; told 'leave out'

expect 0 "$af2" inspect "$models/plate.poly" --json --size 1
cp out plate.json
expect 0 "$af2" mesh "$models/die.step" -s 2 -o die.stl
expect 0 "$af2" inspect die.stl --json
cp out stl.json
python3 - <<'PYTHON' || fail "the numbers of models that are no CAD models"
import json
for name in ("plate.json", "stl.json"):
    model = json.load(open(name))
    faces = {face["id"]: face for face in model["faces"]}
    assert faces and model["diagonal"] > 0
    for face in faces.values():
        assert face["area"] > 0 and all(face["id"] in faces[other]["neighbors"] for other in face["neighbors"]), face
        assert all(low <= high for low, high in zip(face["box"]["low"], face["box"]["high"])), face
    for edge in model["edges"]:
        assert all(edge["id"] in faces[face]["edges"] for face in edge["faces"]), edge
PYTHON
expect 2 "$af2" inspect "$models/plate.poly" --json --edges; told 'leave out'

# Names wherever numbers are taken, in the spelling of mesh files, too.
expect 0 "$af2" mesh "$models/bolt_on_plate.brep" -s 2 --faces 'solid 2' --report named.json -o named.vtu
expect 0 "$af2" inspect "$models/bolt_on_plate.brep" --json
cp out bolt.json
python3 - <<'PYTHON' || fail "the faces of a solid by its name"
import json
wanted = json.load(open("bolt.json"))["solids"][1]["faces"]
faces = json.load(open("named.json"))["faces"]
assert [face["id"] for face in faces if face["status"] == "complete"] == wanted, faces
PYTHON
list=$(python3 -c 'import json; print(",".join(map(str, json.load(open("bolt.json"))["solids"][1]["faces"])))')
expect 0 "$af2" mesh "$models/bolt_on_plate.brep" -s 2 --face-size 'solid 2=1' -o named.vtu
expect 0 "$af2" mesh "$models/bolt_on_plate.brep" -s 2 --face-size "$list=1" -o numbered.vtu
same named.vtu numbered.vtu
expect 1 "$af2" mesh "$models/die.step" -s 2 --faces nobody; told "no face or group called 'nobody'"
expect 1 "$af2" mesh "$models/plate.poly" -s 2 --faces nobody; told "no face or group called 'nobody'"
expect 2 "$af2" mesh "$models/die.step" -s 2 --faces 3x; told "'3x' is neither a number nor a range"
expect 0 "$af2" mesh "$models/bolt_on_plate.brep" -s 2 --trace a.af2t --trace-faces 'solid 2'
expect 0 "$af2" mesh "$models/bolt_on_plate.brep" -s 2 --trace b.af2t --trace-faces "$list"
[ "$(wc -c <a.af2t)" -gt 100 ] || fail "the trace of a solid is empty"
expect 1 "$af2" mesh "$models/bolt_on_plate.brep" -s 2 --trace c.af2t --trace-faces nobody; told "'nobody'"
[ ! -e c.af2t ] || fail "there is a trace of nobody"
expect 2 "$af2" mesh "$models/bolt_on_plate.brep" -s 2 --periodic nobody=3; told "no face or group called 'nobody'"
expect 2 "$af2" mesh "$models/bolt_on_plate.brep" -s 2 --periodic 'solid 2=3'; told "faces are called 'solid 2'"
expect 1 "$af2" mesh "$models/bolt_on_plate.brep" -s 2 --edge-size 'nobody=1'; told "no edges called 'nobody'"
finish
