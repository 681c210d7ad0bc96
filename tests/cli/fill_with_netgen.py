"""fill_with_netgen.py VOL TEXT: lets Netgen make tetrahedra in a .vol file, and writes lines "v NUMBER X Y Z" and
"t DOMAIN VERTEX VERTEX VERTEX VERTEX" (a file, because Netgen itself prints much)."""

import sys

from netgen.meshing import Mesh

mesh = Mesh()
mesh.Load(sys.argv[1])
mesh.GenerateVolumeMesh()
with open(sys.argv[2], "w", encoding="utf-8") as text:
    for number, point in enumerate(mesh.Points(), 1):
        print("v", number, *point.p, file=text)
    for element in mesh.Elements3D():
        print("t", element.index, *(vertex.nr for vertex in element.vertices), file=text)
