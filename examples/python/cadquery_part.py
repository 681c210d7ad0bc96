"""A part of CadQuery (or build123d, pythonocc, Netgen), without a file in between. Needs CadQuery.

Faces keep the order that they have in CadQuery, so that a selector there finds the face here.
"""

import sys

import af2

try:
    import cadquery as cq
except ImportError:
    sys.exit(print("CadQuery is not installed"))

part = cq.Workplane("XY").box(4, 3, 1).faces(">Z").workplane().hole(1)
shape = part.val()
top = 1 + next(i for i, face in enumerate(shape.Faces()) if face.hashCode() == part.faces(">Z").val().hashCode())

mesh = af2.mesh(part, size=0.4, names={"top": top}, face_sizes={"top": 0.1})
print(mesh, "with", (mesh.face == top).sum(), "elements on the top face")
