"""Holds the sample cube, as meshio and VTK read it from files for solvers and viewers, to what was written."""
import pathlib
import re
import sys

import meshio
import numpy as np

directory = pathlib.Path(sys.argv[1])
CORNERS = [[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
FACES = [1, 1, 2, 2, 3, 3, 4, 4, 5, 5]


def surface_area(points, cells):
    p = points[cells]
    return sum(np.linalg.norm(np.cross(p[:, i - 1] - p[:, 0], p[:, i] - p[:, 0]), axis=1).sum() / 2
               for i in range(2, cells.shape[1]))


def check_cube(mesh, what):
    assert mesh.points.tolist() == CORNERS, what
    counts = {kind: sum(len(block.data) for block in mesh.cells if block.type == kind) for kind in ("triangle", "quad")}
    assert counts == {"triangle": 10, "quad": 1}, (what, counts)
    assert abs(sum(surface_area(mesh.points, block.data) for block in mesh.cells) - 6) < 1e-12, what


def check_second_order(mesh, what):
    assert len(mesh.points) == 8 + 17, what
    sizes = {"triangle6": 3, "quad8": 4}
    assert sorted({block.type for block in mesh.cells}) == sorted(sizes), what
    for block in mesh.cells:
        size = sizes[block.type]
        corners = mesh.points[block.data[:, :size]]
        middles = (corners + np.roll(corners, -1, axis=1)) / 2
        assert np.abs(mesh.points[block.data[:, size:]] - middles).max() < 1e-12, what


# Abaqus and CalculiX.
def element_sets(name):
    """By set: the numbers of its elements. meshio mixes sets up that have several blocks."""
    sets, own = {}, None
    for line in (directory / name).read_text().splitlines():
        if line.startswith("*"):
            found = re.search(r"ELSET=(\S+)$", line)
            own = sets.setdefault(found.group(1), []) if found else None
            is_block = line.startswith("*ELEMENT")
        elif own is not None:
            words = [word for word in line.split(",") if word.strip()]
            own += [int(words[0])] if is_block else [int(word) if word.strip().isdigit() else word for word in words]
    return sets


inp = meshio.read(directory / "cube.inp")
check_cube(inp, ".inp")
sets = element_sets("cube.inp")
assert sets.pop("all_elements") == ["face_1", "face_2", "face_3", "face_4", "face_5", "lid"]
assert sets == {"face_1": [1, 2], "face_2": [3, 4], "face_3": [5, 6], "face_4": [7, 8], "face_5": [9, 10], "lid": [11],
                "lower_half": [1, 2, 3, 4], "lid_layer": [11], "color_ff8000": [3, 4, 11],
                "solid_1": list(range(1, 12))}, sets
assert sorted(inp.point_sets) == sorted([*sets, "all_nodes"]) or sorted(inp.point_sets) == sorted(sets)
assert inp.point_sets["lid"].tolist() == [4, 5, 6, 7] and len(inp.point_sets["solid_1"]) == 8
assert element_sets("grouped.inp").keys() == {"all_elements", "lower_half", "face_3", "face_4", "face_5", "lid"}
marked = meshio.read(directory / "marked.inp")
assert marked.point_sets["boundary_5"].tolist() == [4, 5, 6, 7] and marked.point_sets["inlet"].tolist() == [5, 6]
sides = {name: own for name, own in element_sets("marked.inp").items() if "side" in name}
# Vertices 4 to 7 are the lid's; the faces beside it have lower numbers, and so their elements come first.
corners = {number: block for number, block in zip(range(1, 11), marked.cells_dict["triangle"])}
for name, ends in [("boundary_5", [{4, 5}, {6, 7}]), ("inlet", [{5, 6}])]:
    found = [{int(corners[e][int(side[-1]) - 1]), int(corners[e][int(side[-1]) % 3])}
             for side, own in sides.items() if side.startswith(name) for e in own]
    assert sorted(map(sorted, found)) == sorted(map(sorted, ends)), (name, sides)
assert "edge_4" not in marked.point_sets and "edge_4" in meshio.read(directory / "lines.inp").point_sets
second = (directory / "cube2.inp").read_text()
assert set(re.findall(r"TYPE=(\w+)", second)) == {"S6", "S8R"}
(directory / "cube2_abaqus.inp").write_text(second.replace("TYPE=S6", "TYPE=STRI65"))  # as Abaqus, meshio has no S6
check_second_order(meshio.read(directory / "cube2_abaqus.inp"), ".inp")

# Nastran.
for extension in (".bdf", ".nas"):
    bdf = meshio.read(directory / f"cube{extension}", "nastran")
    check_cube(bdf, extension)
    assert np.concatenate(bdf.cell_data["nastran:ref"]).tolist() == [*FACES, 6], extension
    check_second_order(meshio.read(directory / f"cube2{extension}", "nastran"), extension)


def case_sets(name):
    """By what the comment before a set of the case control section says: its members."""
    sets, text = {}, (directory / name).read_text().split("BEGIN BULK")[0]
    assert max(map(len, text.splitlines())) <= 72 or "$" in text
    for what, body in re.findall(r"^\$ SET \d+: (.*)\nSET \d+ = ((?:[^$\n].*\n?)+)", text, re.M):
        members = sets.setdefault(what, [])
        for part in body.replace("\n", " ").split(","):
            ends = [int(word) for word in part.split("THRU")]
            members += range(ends[0], ends[-1] + 1)
    return sets


sets = case_sets("cube.bdf")
assert sets["elements of lower half"] == [1, 2, 3, 4] and sets["elements of solid 1"] == list(range(1, 12))
assert sets["elements of color #ff8000"] == [3, 4, 11] and sets["elements of lid (layer)"] == [11]
assert sets["grid points of lid"] == [5, 6, 7, 8] and "elements of lid" not in sets
bulk = (directory / "cube.bdf").read_text().split("BEGIN BULK")[1]
assert re.findall(r"^\$ PSHELL 6: (.*)\nPSHELL  6$", bulk, re.M) == ["lid"]
sets = case_sets("marked.bdf")
assert sets["elements of inlet"] == [13] and sets["grid points of inlet"] == [6, 7]
assert sets["elements of boundary 5"] == [12, 14]
assert re.findall(r"^PLOTEL +(\d+) +(\d+) +(\d+)$", (directory / "marked.bdf").read_text(), re.M) == [
    ("12", "5", "6"), ("13", "6", "7"), ("14", "7", "8")]
