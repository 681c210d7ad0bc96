"""parts.py PARTS OPTIONS: compares parts_0.vtu and so on, and parts_1.msh and so on, with whole.vtu and whole.msh."""

import sys
import xml.etree.ElementTree

try:
    import meshio
    import numpy
except ImportError:
    sys.exit(77)

parts = int(sys.argv[1])


def flat(mesh, name):
    """Data of cells, of all but lines."""
    return numpy.concatenate([data for block, data in zip(mesh.cells, mesh.cell_data[name])])


whole = meshio.read("whole.vtu")
surface = [row for block in whole.cells if not block.type.startswith("line") for row in block.data]
owners = {}
ghosts_of = []
vertex_owner = {}
for part in range(parts):
    mesh = meshio.read(f"parts_{part}.vtu")
    ids = mesh.point_data["GlobalNodeIds"]
    assert numpy.array_equal(mesh.points, whole.points[ids]), "vertices are elsewhere"
    for vertex, owner, number, ghost in zip(
        ids, mesh.point_data["owner"], mesh.point_data["number"], mesh.point_data["vtkGhostType"]
    ):
        assert (owner == part) == (ghost == 0)
        assert vertex_owner.setdefault(vertex, (owner, number)) == (owner, number)
    rows = [row for block in mesh.cells for row in block.data]
    element_ids = flat(mesh, "GlobalElementIds")
    own, ghosts = {}, set()
    for row, element, owner, ghost in zip(
        rows, element_ids, flat(mesh, "owner"), flat(mesh, "vtkGhostType")
    ):
        assert (owner == part) == (ghost == 0)
        if ghost:
            ghosts.add(element)
            continue
        assert element not in owners, "an element has two owners"
        owners[element] = part
        own[element] = set(ids[row])
    ghosts_of.append((own, ghosts))
assert len(owners) == len(surface), f"{len(owners)} of {len(surface)} elements"

# Numbers are consecutive for each owner.
by_number = sorted((number, owner) for owner, number in vertex_owner.values())
assert [number for number, _ in by_number] == list(range(len(whole.points)))
assert [owner for _, owner in by_number] == sorted(owner for _, owner in by_number)

# Ghosts are just those that share a vertex. Orders of cells in files differ, so go by the parts.
corners = {}
for own, _ in ghosts_of:
    corners.update(own)
around = {}
for element, vertices in corners.items():
    for vertex in vertices:
        around.setdefault(vertex, set()).add(element)
for own, ghosts in ghosts_of:
    expected = {other for vertices in own.values() for vertex in vertices for other in around[vertex]}
    assert ghosts == expected - set(own), "other ghosts than expected"
largest, smallest = (f(len(own) for own, _ in ghosts_of) for f in (max, min))
assert largest < 1.2 * smallest + 10, "the parts differ in size"

pieces = [p.get("Source") for p in xml.etree.ElementTree.parse("parts.pvtu").iter("Piece")]
assert pieces == [f"parts_{part}.vtu" for part in range(parts)]

# The files of Gmsh hold the same: tags are those of the whole mesh.
for part in range(parts):
    mesh = meshio.read(f"parts_{part + 1}.msh")
    own, ghosts = ghosts_of[part]
    count = sum(len(b.data) for b in mesh.cells if not b.type.startswith("line"))
    assert count == len(own) + len(ghosts), f"{count} elements in parts_{part + 1}.msh"
    names = set(meshio.read("whole.msh").field_data)
    assert names == set(mesh.field_data), "other physical groups"
