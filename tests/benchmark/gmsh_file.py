"""What a binary .msh file of version 4.1 contains, as far as a comparison needs it."""

import struct
from pathlib import Path

TRIANGLE = 2  # type of elements
# Vertices by type of elements: what a mesh of order 1 of edges and faces has.
CORNERS = {15: 1, 1: 2, TRIANGLE: 3, 3: 4}


def triangles_and_faces(path: Path) -> tuple:
    """How many triangles there are, and on how many faces."""
    data = path.read_bytes()
    mark = b"\n$Elements\n"
    at = data.find(mark)
    if at < 0:
        return 0, 0
    at += len(mark)
    (blocks,) = struct.unpack_from("<Q", data, at)
    at += 4 * 8  # blocks, elements, least tag, largest tag
    triangles, faces = 0, set()
    for _ in range(blocks):
        dimension, entity, kind, count = struct.unpack_from("<iiiQ", data, at)
        at += 20 + 8 * count * (1 + CORNERS[kind])
        if dimension == 2 and kind == TRIANGLE:
            triangles += count
            faces.add(entity)
    return triangles, len(faces)
