"""Holds the sample cube, as other programs read it from MED, Exodus II and CGNS files, to what was written: meshio
with h5py, VTK, netCDF's and CGNS's own programs, each if it is there. Exit code 77: there are no such files."""
import pathlib
import re
import shutil
import subprocess
import sys

import meshio
import numpy as np

directory = pathlib.Path(sys.argv[1])
CORNERS = [[x, y, z] for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
GROUPS = {"face 1": [1, 2], "face 2": [3, 4], "face 3": [5, 6], "face 4": [7, 8], "face 5": [9, 10], "lid": [11],
          "lower half": [1, 2, 3, 4], "lid (layer)": [11], "color #ff8000": [3, 4, 11], "solid 1": list(range(1, 12))}
EDGES = {"boundary 5": {(4, 5), (6, 7)}, "inlet": {(5, 6)}}


def area(mesh):
    total = 0
    for block in mesh.cells:
        if block.type in ("triangle", "quad"):
            p = mesh.points[block.data]
            total += sum(np.linalg.norm(np.cross(p[:, i - 1] - p[:, 0], p[:, i] - p[:, 0]), axis=1).sum() / 2
                         for i in range(2, p.shape[1]))
    return total


def check_second_order(cells, points, what):
    counts = {}
    for kind, corners in cells:
        size = {"triangle6": 3, "quad8": 4, "line3": 2}[kind]
        counts[kind] = counts.get(kind, 0) + len(corners)
        ends = points[corners[:, :size]]
        after = np.roll(ends, -1, axis=1) if size > 2 else ends[:, ::-1]
        middles = ((ends + after) / 2)[:, :size if size > 2 else 1]
        assert np.abs(points[corners[:, size:]] - middles).max() < 1e-15, (what, kind)
    assert counts["triangle6"] == 10 and counts["quad8"] == 1, (what, counts)


def check_med():
    mesh = meshio.read(directory / "marked.med")
    assert mesh.points.tolist() == CORNERS and abs(area(mesh) - 6) < 1e-12
    numbers = {"triangle": list(range(1, 11)), "quad": [11]}
    groups, edges = {}, {}
    for block, families in zip(mesh.cells, mesh.cell_data["cell_tags"]):
        for i, (corners, family) in enumerate(zip(block.data.tolist(), families)):
            for name in mesh.cell_tags[family]:
                if block.type == "line":
                    edges.setdefault(name, set()).add(tuple(sorted(corners)))
                else:
                    groups.setdefault(name, []).append(numbers[block.type][i])
    assert {name: sorted(own) for name, own in groups.items()} == GROUPS, groups
    assert edges == EDGES, edges
    lines = meshio.read(directory / "lines2.med")
    check_second_order([(block.type, block.data) for block in lines.cells], lines.points, "MED")
    assert len(lines.cells_dict["line3"]) == 4
    grouped = meshio.read(directory / "grouped.med")
    assert {name for names in grouped.cell_tags.values() for name in names} == {
        "lower half", "face 3", "face 4", "face 5", "lid"}
    if shutil.which("medconforme"):
        told = subprocess.run(["medconforme", "lines2.med"], cwd=directory, capture_output=True, text=True)
        assert told.returncode == 0 and "non conforme" not in told.stdout, told.stdout


def ncdump(name):
    """The arrays of a file, by name."""
    text = subprocess.run(["ncdump", name], cwd=directory, capture_output=True, text=True, check=True).stdout
    return {key: [value.strip().strip('"') for value in values.split(",")]
            for key, values in re.findall(r"^ (\w+) =\s([^;]*) ;", text.split("\ndata:")[1], re.M)}


def check_exodus_sets():
    """meshio has no sets of elements, and those of VTK 9.1 are empty."""
    arrays = ncdump("marked.exo")
    order = [int(number) for number in arrays["elem_num_map"]]
    assert order == list(range(1, 12))  # so that places are numbers
    found = {name: [int(e) for e in arrays[f"elem_els{i}"]] for i, name in enumerate(arrays["els_names"], 1)}
    assert found == {name: own for name, own in GROUPS.items() if name not in arrays["eb_names"]}, found
    assert arrays["eb_names"] == [name for name in GROUPS if name.startswith("face") or name == "lid"]


def check_exodus():
    if shutil.which("ncdump"):
        check_exodus_sets()
    try:
        from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
        from vtkmodules.vtkIOExodus import vtkExodusIIReader
    except ImportError:
        return

    def read(name, kinds):
        reader = vtkExodusIIReader()
        reader.SetFileName(str(directory / name))
        reader.UpdateInformation()
        for kind in kinds:
            for i in range(reader.GetNumberOfObjects(kind)):
                reader.SetObjectStatus(kind, i, 1)
        reader.Update()
        return list(leaves(reader.GetOutput(), vtkCompositeDataSet))
    blocks = read("marked.exo", [vtkExodusIIReader.ELEM_BLOCK])
    assert [(name, data.GetNumberOfCells()) for name, data in blocks] == [
        ("face 1", 2), ("face 2", 2), ("face 3", 2), ("face 4", 2), ("face 5", 2), ("lid", 1)], blocks
    sides = dict(read("marked.exo", [vtkExodusIIReader.SIDE_SET]))
    overlapping = {name: len(own) for name, own in GROUPS.items() if name not in dict(blocks)}
    assert {name: sides[name].GetNumberOfCells() for name in overlapping} == overlapping
    for name, ends in EDGES.items():
        data = sides[name]
        found = {tuple(sorted(CORNERS.index(list(data.GetPoint(data.GetCell(i).GetPointId(k)))) for k in (0, 1)))
                 for i in range(data.GetNumberOfCells()) if data.GetCell(i).GetNumberOfPoints() == 2}
        assert found == ends, (name, found)
    second = read("cube2.exo", [vtkExodusIIReader.ELEM_BLOCK])
    for name, data in second:
        points = np.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
        kind = "quad8" if name == "lid" else "triangle6"
        cells = np.array([[data.GetCell(i).GetPointId(k) for k in range(data.GetCell(i).GetNumberOfPoints())]
                          for i in range(data.GetNumberOfCells())])
        size = 4 if kind == "quad8" else 3
        ends = points[cells[:, :size]]
        assert np.abs(points[cells[:, size:]] - (ends + np.roll(ends, -1, axis=1)) / 2).max() < 1e-15, name


def leaves(data, composite, name=""):
    if data is None:
        return
    if not hasattr(data, "GetNumberOfBlocks"):
        yield name, data
        return
    for i in range(data.GetNumberOfBlocks()):
        own = data.GetMetaData(i).Get(composite.NAME()) if data.HasMetaData(i) else ""
        yield from leaves(data.GetBlock(i), composite, own)


def check_cgns():
    if shutil.which("cgnscheck"):
        for name in ("cube.cgns", "marked.cgns", "lines.cgns", "lines2.cgns", "grouped.cgns"):
            told = subprocess.run(["cgnscheck", name], cwd=directory, capture_output=True, text=True)
            assert told.returncode == 0 and "ERROR" not in told.stdout, told.stdout
    import h5py  # meshio needs it for MED, too
    with h5py.File(directory / "marked.cgns") as file:
        zone = file["Base/Zone"]
        data = lambda node: node[" data"][:].flatten().tolist()
        kind = lambda node: node.attrs["label"].decode()
        points = np.column_stack([zone[f"GridCoordinates/Coordinate{axis}/ data"][:] for axis in "XYZ"])
        assert points.tolist() == CORNERS
        ranges = {name: data(node["ElementRange"]) for name, node in zone.items() if kind_is(node, kind, "Elements_t")}
        corners = {name: np.reshape(data(node["ElementConnectivity"]), (ranges[name][1] - ranges[name][0] + 1, -1)) - 1
                   for name, node in zone.items() if kind_is(node, kind, "Elements_t")}
        for name, own in GROUPS.items():
            if name in ranges:
                assert list(range(ranges[name][0], ranges[name][1] + 1)) == own, name
            else:
                assert data(zone[name]["PointList"]) == own, name
        for name, ends in EDGES.items():
            assert data(zone["ZoneBC"][name]["PointRange"]) == ranges[name], name
            assert {tuple(sorted(line)) for line in corners[name].tolist()} == ends, name
            assert bytes(zone["ZoneBC"][name]["FamilyName"][" data"][:]).decode() == name
        total = sum(abs(np.linalg.norm(np.cross(points[c[1]] - points[c[0]], points[c[2]] - points[c[0]]))) *
                    (0.5 if len(c) == 3 else 1) for name, block in corners.items() if name not in EDGES for c in block)
        assert abs(total - 6) < 1e-12
    try:
        from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
        from vtkmodules.vtkIOCGNSReader import vtkCGNSReader
    except ImportError:
        return
    reader = vtkCGNSReader()
    reader.SetFileName(str(directory / "marked.cgns"))
    reader.UpdateInformation()
    reader.EnableAllBases()
    reader.LoadBndPatchOn()
    reader.Update()
    found = {name: data.GetNumberOfCells() for name, data in leaves(reader.GetOutput(), vtkCompositeDataSet)}
    assert found == {"Internal": 11, "boundary 5": 2, "inlet": 1}, found


def kind_is(node, kind, label):
    return "label" in node.attrs and kind(node) == label


checks = {"med": check_med, "exo": check_exodus, "cgns": check_cgns}
there = [extension for extension in checks if (directory / f"cube.{extension}").exists()]
for extension in there:
    checks[extension]()
print("checked:", *there)
sys.exit(0 if there else 77)
