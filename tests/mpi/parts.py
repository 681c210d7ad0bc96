"""parts.py PARTS OPTIONS: compares parts_0.vtu and so on, and parts_1.msh and so on, with whole.vtu."""

import struct
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



class Msh:
    """A binary file of Gmsh 4.1, section by section. meshio does not know partitioned entities."""

    def __init__(self, name):
        self.data, self.at = open(name, "rb").read(), 0

    def seek(self, section):
        self.at = self.data.index(b"$" + section + b"\n") + len(section) + 2

    def take(self, *kinds):
        values = struct.unpack_from("<" + "".join(kinds), self.data, self.at)
        self.at += struct.calcsize("<" + "".join(kinds))
        return values if len(values) > 1 else values[0]

    def entities(self, are_parts):
        """Dimension and tag of each, with its parent and its groups."""
        found = {}
        for dimension, count in enumerate(self.take("4Q")):
            for _ in range(count):
                tag, parent = self.take("i"), None
                if are_parts:
                    parent = self.take("2i")
                    self.take(f"{self.take('Q')}i", "0i")
                self.take("6d")
                groups = [self.take("i") for _ in range(self.take("Q"))]
                assert self.take("Q") == 0
                found[dimension, tag] = (parent, groups)
        return found

    def nodes(self):
        self.seek(b"Nodes")
        blocks, points = self.take("4Q")[0], {}
        for _ in range(blocks):
            self.take("3i")
            tags = [self.take("Q") for _ in range(self.take("Q"))]
            points.update((tag, self.take("3d")) for tag in tags)
        return points

    def elements(self):
        self.seek(b"Elements")
        found = {}
        for _ in range(self.take("4Q")[0]):
            dimension, entity, kind = self.take("3i")
            for _ in range(self.take("Q")):
                tag, *nodes = self.take(f"{1 + NODES[kind]}Q")
                found[tag] = (dimension, entity, nodes)
        return found


NODES = {1: 2, 2: 3, 3: 4, 8: 3, 9: 6, 16: 8}
for part in range(parts):
    msh = Msh(f"parts_{part + 1}.msh")
    own, ghosts = ghosts_of[part]
    msh.seek(b"Entities")
    parents = msh.entities(False)
    msh.seek(b"PartitionedEntities")
    assert msh.take("2Q") == (parts, 1)
    ghost_entity, partition = msh.take("2i")
    assert partition == part + 1
    entities = msh.entities(True)
    for parent, groups in entities.values():
        assert parents[parent][1] == groups, "a part has other groups than its face"
    points = msh.nodes()
    for tag, point in points.items():
        assert numpy.array_equal(point, whole.points[tag - 1]), "a node is elsewhere"
    surface = {tag - 1: element for tag, element in msh.elements().items() if element[0] == 2}
    assert set(surface) == set(own) | ghosts
    for element, (dimension, entity, nodes) in surface.items():
        assert (entity == ghost_entity) == (element in ghosts)
        assert all(node in points for node in nodes)
        assert element in ghosts or {node - 1 for node in nodes} == own[element]
    msh.seek(b"GhostElements")
    told = [msh.take("Qi", "Qi") for _ in range(msh.take("Q"))]
    assert {tag - 1: owner - 1 for tag, owner, _, _ in told} == {e: owners[e] for e in ghosts}
    assert all(count == 1 and where == part + 1 for _, _, count, where in told)
