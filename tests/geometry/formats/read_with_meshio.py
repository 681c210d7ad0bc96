"""Holds the sample cube, as meshio reads it, to what was written."""
import sys

import meshio
import numpy as np

directory = sys.argv[1]
FACES = [1, 1, 2, 2, 3, 3, 4, 4, 5, 5]


def read(extension, name="cube"):
    return meshio.read(f"{directory}/{name}{extension}")


def surface_area(mesh):
    area = 0.0
    for kind, corners in mesh.cells_dict.items():
        p = mesh.points[corners]
        for i in range(2, corners.shape[1]):
            area += np.linalg.norm(np.cross(p[:, i - 1] - p[:, 0], p[:, i] - p[:, 0]), axis=1).sum() / 2
    return area


for extension in [".vtu", ".vtk", ".msh", ".stl", ".obj", ".ply"]:
    mesh = read(extension)
    assert abs(surface_area(mesh) - 6) < 1e-12, extension
    if extension != ".stl":
        assert len(mesh.points) == 8, extension
        assert len(mesh.cells_dict["triangle"]) == 10, extension
        assert len(mesh.cells_dict["quad"]) == 1, extension

for extension in [".vtu", ".vtk"]:
    mesh = read(extension)
    assert mesh.cell_data_dict["face"]["triangle"].tolist() == FACES, extension
    assert mesh.cell_data_dict["face"]["quad"].tolist() == [6], extension
    assert mesh.cell_data_dict["rule"]["quad"].tolist() == [2], extension
    assert abs(mesh.cell_data_dict["quality"]["quad"][0] - 1) < 1e-15, extension
assert read(".vtu").field_data["rule: right 60"].tolist() == [1]

packed, plain = read(".vtu", "packed"), read(".vtu")
assert (packed.points == plain.points).all()
for kind, corners in plain.cells_dict.items():
    assert (packed.cells_dict[kind] == corners).all(), kind
for name, values in plain.cell_data_dict.items():
    for kind in values:
        assert (packed.cell_data_dict[name][kind] == values[kind]).all(), name

msh = read(".msh")
assert msh.cell_data_dict["gmsh:physical"]["triangle"].tolist() == FACES
assert msh.cell_data_dict["gmsh:geometrical"]["quad"].tolist() == [6]
assert msh.field_data["lid"].tolist() == [6, 2]
assert msh.field_data["face 3"].tolist() == [3, 2]

# Groups: by number and name; a face may be in several.
assert read(".vtu").field_data["part: lower half"].tolist() == [1, 2]
assert read(".vtu").field_data["solid: 1"].tolist() == [1, 2, 3, 4, 5, 6]
assert read(".vtu").cell_data_dict["solid"]["quad"].tolist() == [1]
assert read(".vtu").cell_data_dict["color"]["quad"].tolist() == [[255, 128, 0]]
assert msh.field_data["lower half"].tolist() == [7, 2]
assert msh.field_data["lid (layer)"].tolist() == [8, 2]
assert msh.field_data["color #ff8000"].tolist() == [9, 2]
assert msh.field_data["solid 1"].tolist() == [10, 2]
assert msh.field_data["solid 1 (volume)"].tolist() == [1, 3]

assert read(".vtu").field_data["face: lid"].tolist() == [6]

# Named solids of a text STL file, which meshio reads, too.
import re

text = open(f"{directory}/grouped.stl").read()
assert abs(surface_area(read(".stl", "grouped")) - 6) < 1e-12
solids = re.findall(r"^solid ([^\n]*)\n(.*?)^endsolid ([^\n]*)\n", text, re.M | re.S)
assert all(first == last for first, _, last in solids)
assert {name: body.count("facet normal") for name, body, _ in solids} == {
    "lower half": 4, "face 3": 2, "face 4": 2, "face 5": 2, "lid": 2}, solids

# Elements of second order.
for extension in [".vtu", ".msh"]:
    mesh = meshio.read(f"{directory}/cube2{extension}")
    assert len(mesh.points) == 8 + 17, extension
    triangles, quads = mesh.cells_dict["triangle6"], mesh.cells_dict["quad8"]
    assert triangles.shape == (10, 6) and quads.shape == (1, 8), extension
    for cells, size in [(triangles, 3), (quads, 4)]:
        corners = mesh.points[cells[:, :size]]
        middles = (corners + np.roll(corners, -1, axis=1)) / 2
        assert np.abs(mesh.points[cells[:, size:]] - middles).max() < 1e-15, extension

# Lines along edges: those of boundaries, or of all edges.
TOP = [[4, 5], [5, 6], [6, 7], [7, 4]]
for extension in [".vtu", ".vtk"]:
    marked = read(extension, "marked")
    assert marked.cells_dict["line"].tolist() == TOP[:3], extension
    assert marked.cell_data_dict["edge"]["line"].tolist() == [1, 2, 3], extension
    assert marked.cell_data_dict["boundary"]["line"].tolist() == [5, -2, 5], extension
    assert marked.cell_data_dict["boundary"]["quad"].tolist() == [0], extension
    assert marked.cell_data_dict["face"]["triangle"].tolist() == FACES, extension
    assert marked.cell_data_dict["face"]["line"].tolist() == [0, 0, 0], extension
    assert np.isnan(marked.cell_data_dict["quality"]["line"]).all(), extension
    lines = read(extension, "lines")
    assert lines.cells_dict["line"].tolist() == TOP, extension
    assert lines.cell_data_dict["boundary"]["line"].tolist() == [5, -2, 5, 0], extension
fields = read(".vtu", "marked").field_data
assert fields["boundary: 5"].tolist() == [1, 3] and fields["boundary: inlet"].tolist() == [2]

marked, lines = read(".msh", "marked"), read(".msh", "lines")
PLACES = read(".vtu").points[TOP]  # points of an .msh file stand in another order
assert (marked.points[marked.cells_dict["line"]] == PLACES[:3]).all()
assert marked.cell_data_dict["gmsh:geometrical"]["line"].tolist() == [1, 2, 3]
assert marked.cell_data_dict["gmsh:physical"]["line"].tolist() == [5, 6, 5]
assert marked.field_data["boundary 5"].tolist() == [5, 1] and marked.field_data["inlet"].tolist() == [6, 1]
assert "edge 4" not in marked.field_data
assert lines.cell_data_dict["gmsh:physical"]["line"].tolist() == [5, 6, 5, 6 + 4]
assert lines.field_data["edge 4"].tolist() == [10, 1]
assert marked.cell_data_dict["gmsh:physical"]["triangle"].tolist() == FACES

for extension in [".vtu", ".msh"]:
    mesh = read(extension, "lines2")
    corners = mesh.cells_dict["line3"]
    assert (mesh.points[corners[:, :2]] == PLACES).all(), extension
    middles = mesh.points[corners[:, :2]].mean(axis=1)
    assert np.abs(mesh.points[corners[:, 2]] - middles).max() < 1e-15, extension
