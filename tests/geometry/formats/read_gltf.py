"""Holds the sample cube, as VTK reads it from a glTF file, to what was written. Exit code 77: there is no VTK."""
import json
import pathlib
import struct
import sys

try:
    from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkMassProperties, vtkTriangleFilter
    from vtkmodules.vtkIOGeometry import vtkGLTFReader
except ImportError:
    print("no VTK for this Python")
    sys.exit(77)

directory = pathlib.Path(sys.argv[1])


def blocks(data):
    if data is None:
        return
    if not hasattr(data, "GetNumberOfBlocks"):
        yield data
        return
    for i in range(data.GetNumberOfBlocks()):
        yield from blocks(data.GetBlock(i))


def read(name):
    reader = vtkGLTFReader()
    reader.SetFileName(str(directory / name))
    reader.ApplyDeformationsToGeometryOn()
    reader.Update()
    return list(blocks(reader.GetOutput()))


def head(name):
    content = (directory / name).read_bytes()
    magic, version, size, length = struct.unpack("<4sIII", content[:16])
    assert (magic, version, size) == (b"glTF", 2, len(content)) and length % 4 == 0
    return json.loads(content[20:20 + length])


parts = read("marked.glb")
surfaces = [part for part in parts if part.GetNumberOfPolys() > 0]
assert [part.GetNumberOfPolys() for part in surfaces] == [2] * 6
merged = vtkAppendPolyData()
for part in surfaces:
    merged.AddInputData(part)
triangles = vtkTriangleFilter()
triangles.SetInputConnection(merged.GetOutputPort())
measures = vtkMassProperties()
measures.SetInputConnection(triangles.GetOutputPort())
assert abs(measures.GetSurfaceArea() - 6) < 1e-6
bounds = [part.GetBounds() for part in surfaces]
low = [min(b[i] for b in bounds) for i in (0, 2, 4)]
high = [max(b[i] for b in bounds) for i in (1, 3, 5)]
assert max(abs(a - b) for a, b in zip(low + high, [0, 0, -1, 1, 1, 0])) < 1e-6, (low, high)  # y is up

json_head = head("marked.glb")
named = {node["name"]: node for node in json_head["nodes"]}
assert named["lid"]["extras"] == {"face": 6, "groups": ["lid", "lid (layer)", "color #ff8000", "solid 1"]}
assert named["face 1"]["extras"]["groups"] == ["face 1", "lower half", "solid 1"]
lines = {name: json_head["accessors"][json_head["meshes"][node["mesh"]]["primitives"][0]["indices"]]["count"] // 2
         for name, node in named.items() if "mesh" in node and
         json_head["meshes"][node["mesh"]]["primitives"][0]["mode"] == 1}
assert lines == {"boundary 5": 2, "inlet": 1, "sides of elements": 17}, lines
color = json_head["materials"][json_head["meshes"][named["lid"]["mesh"]]["primitives"][0]["material"]]
assert color["name"] == "#ff8000"
assert max(abs(a - b) for a, b in zip(color["pbrMetallicRoughness"]["baseColorFactor"], [1, 0.2158605, 0, 1])) < 1e-6
