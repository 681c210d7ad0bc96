#!/usr/bin/python3
"""Meshes a CAD file with Gmsh, for comparison.

    gmsh_driver.py MODEL SIZE [--curvature N] [--obj FILE]

At one uniform size; with N, also with N elements around a full turn. FILE gets the mesh. Prints one line of JSON like the other drivers. A process of its own, so that nothing of AF2 is
linked with Gmsh.
"""

import argparse
import json
import resource
import sys

import gmsh
import numpy

FRONTAL_DELAUNAY = 6


def options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("model")
    parser.add_argument("size", type=float)
    parser.add_argument("--curvature", type=float, default=0)
    parser.add_argument("--obj")
    return parser.parse_args()


def mesh(model: str, size: float, curvature: float) -> float:
    """Meshes edges and faces; user seconds spent on that, without reading the file."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("General.NumThreads", 1)
    gmsh.option.setNumber("Mesh.Algorithm", FRONTAL_DELAUNAY)
    if curvature:
        gmsh.option.setNumber("Mesh.MeshSizeFromCurvature", curvature)
    else:
        gmsh.option.setNumber("Mesh.MeshSizeMin", size)
    gmsh.option.setNumber("Mesh.MeshSizeMax", size)
    gmsh.open(model)
    start = resource.getrusage(resource.RUSAGE_SELF).ru_utime
    gmsh.model.mesh.generate(2)
    return resource.getrusage(resource.RUSAGE_SELF).ru_utime - start


def triangles() -> tuple:
    """Points by tag, and the tags of the corners."""
    tags, coordinates, _ = gmsh.model.mesh.getNodes()
    points = numpy.zeros((int(tags.max()) + 1, 3))
    points[tags] = numpy.reshape(coordinates, (-1, 3))
    _, corners = gmsh.model.mesh.getElementsByType(2)
    return points, numpy.reshape(corners, (-1, 3)).astype(int)


def qualities(points: numpy.ndarray, corners: numpy.ndarray) -> numpy.ndarray:
    """4 sqrt(3) area / sum of squared edges of each triangle, sorted."""
    a, b, c = (points[column] for column in corners.T)
    area = numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1) / 2
    edges = sum(((p - q) ** 2).sum(axis=1) for p, q in ((a, b), (b, c), (c, a)))
    return numpy.sort(4 * numpy.sqrt(3) * area / edges)


def write_obj(path: str, points: numpy.ndarray, corners: numpy.ndarray) -> None:
    with open(path, "w") as file:
        numpy.savetxt(file, points[1:], "v %.17g %.17g %.17g")  # tag 1 is the first line
        numpy.savetxt(file, corners, "f %d %d %d")


def main() -> int:
    chosen = options()
    seconds = mesh(chosen.model, chosen.size, chosen.curvature)
    points, corners = triangles()
    if chosen.obj:
        write_obj(chosen.obj, points, corners)
    quality = qualities(points, corners)
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
