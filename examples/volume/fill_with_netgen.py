#!/usr/bin/python3
"""Fills the solids of a mesh of `af2 mesh` with tetrahedra by Netgen: fill_with_netgen.py MESH.vol [OUTPUT.vtu]

Debian's package python3-netgen is needed, and python3-meshio for the output. The triangles stay as they are."""
import sys

import numpy as np
from netgen.meshing import Mesh


def main(source, output=None):
    mesh = Mesh()
    mesh.Load(source)
    mesh.GenerateVolumeMesh()
    points = np.array([p.p for p in mesh.Points()])
    elements = list(mesh.Elements3D())
    domains = np.array([e.index for e in elements], dtype=int)
    # Netgen counts from 1, and its tetrahedra have the other orientation.
    tetrahedra = np.array([[v.nr - 1 for v in e.vertices] for e in elements], dtype=int).reshape(-1, 4)[:, [0, 1, 3, 2]]
    a, b, c, d = (points[tetrahedra[:, i]] for i in range(4))
    volumes = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6
    for domain in np.unique(domains):
        own = volumes[domains == domain]
        print(f"domain {domain}, {mesh.GetMaterial(int(domain))}: {len(own)} tetrahedra, volume {own.sum():.9g}")
    if output:
        import meshio
        meshio.write(output, meshio.Mesh(points, [("tetra", tetrahedra)], cell_data={"domain": [domains]}))
    return 0 if len(tetrahedra) > 0 and volumes.min() > 0 else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
