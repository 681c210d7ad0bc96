#!/usr/bin/python3
"""Meshes a STEP file with Gmsh at one uniform size, for comparison: gmsh_driver.py MODEL SIZE.

Prints one line of JSON like the other drivers. A process of its own, so that nothing of AF2 is
linked with Gmsh.
"""

import json
import resource
import sys

import gmsh
import numpy

FRONTAL_DELAUNAY = 6


def mesh(model: str, size: float) -> float:
    """Meshes edges and faces; user seconds spent on that, without reading the file."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("General.NumThreads", 1)
    gmsh.option.setNumber("Mesh.Algorithm", FRONTAL_DELAUNAY)
    gmsh.option.setNumber("Mesh.MeshSizeMin", size)
    gmsh.option.setNumber("Mesh.MeshSizeMax", size)
    gmsh.open(model)
    start = resource.getrusage(resource.RUSAGE_SELF).ru_utime
    gmsh.model.mesh.generate(2)
    return resource.getrusage(resource.RUSAGE_SELF).ru_utime - start


def qualities() -> numpy.ndarray:
    """4 sqrt(3) area / sum of squared edges of each triangle, sorted."""
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    points = numpy.zeros((int(tags.max()) + 1, 3))
    points[tags] = numpy.reshape(coordinates, (-1, 3))
    _, corners = gmsh.model.mesh.getElementsByType(2)
    a, b, c = (points[column] for column in numpy.reshape(corners, (-1, 3)).T)
    area = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1) / 2
    edges = sum(((p - q) ** 2).sum(axis=1) for p, q in ((a, b), (b, c), (c, a)))
    return numpy.sort(4 * numpy.sqrt(3) * area / edges)


def main() -> int:
    if len(sys.argv) != 3:
        print("usage: gmsh_driver.py MODEL.step SIZE", file=sys.stderr)
        return 2
    seconds = mesh(sys.argv[1], float(sys.argv[2]))
    quality = qualities()
    print(json.dumps({
        "triangles": len(quality),
        "seconds": seconds,
        "min": round(float(quality[0]), 4),
        "percentile1": round(float(quality[len(quality) // 100]), 4),
        "mean": round(float(quality.mean()), 4),
        "mebibytes": round(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024),
    }))
    return 0


if __name__ == "__main__":
    sys.exit(main())
