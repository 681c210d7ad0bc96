#!/usr/bin/python3
"""Fills a closed mesh of triangles with tetrahedra by Netgen: fill_with_netgen.py MESH.vtu [OUTPUT.vtu]

Debian's packages python3-netgen and python3-meshio are needed. The triangles stay as they are."""
import sys

import meshio
import numpy as np
from netgen.meshing import Element2D, FaceDescriptor, Mesh, MeshPoint, Pnt


def surface_of(mesh):
    """The same mesh as Netgen has it, each model face with a boundary condition of its own."""
    surface = Mesh()
    points = [surface.Add(MeshPoint(Pnt(*p))) for p in mesh.points]
    faces = mesh.cell_data_dict["face"]["triangle"]
    index = {face: surface.Add(FaceDescriptor(surfnr=int(face), domin=1, bc=int(face))) for face in sorted(set(faces))}
    for face, corners in zip(faces, mesh.cells_dict["triangle"]):
        surface.Add(Element2D(index[face], [points[c] for c in corners]))
    return surface


def main(source, output=None):
    volume = surface_of(meshio.read(source))
    volume.GenerateVolumeMesh()
    points = np.array([p.p for p in volume.Points()])
    # Netgen counts from 1, and its tetrahedra have the other orientation.
    tetrahedra = np.array([[v.nr - 1 for v in e.vertices] for e in volume.Elements3D()], dtype=int)[:, [0, 1, 3, 2]]
    a, b, c, d = (points[tetrahedra[:, i]] for i in range(4))
    volumes = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6
    print(f"{len(tetrahedra)} tetrahedra, volume {volumes.sum():.9g}")
    if output:
        meshio.write(output, meshio.Mesh(points, [("tetra", tetrahedra)]))
    return 0 if len(tetrahedra) > 0 and volumes.min() > 0 else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
