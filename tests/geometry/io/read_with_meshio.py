"""Holds the sample cube, as meshio reads it, to what was written."""
import sys

import meshio
import numpy as np

directory = sys.argv[1]
FACES = [1, 1, 2, 2, 3, 3, 4, 4, 5, 5]


def read(extension):
    return meshio.read(f"{directory}/cube{extension}")


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
