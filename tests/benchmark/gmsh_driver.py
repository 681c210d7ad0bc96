#!/usr/bin/python3
"""Meshes a CAD file with Gmsh, for comparison.

    gmsh_driver.py MODEL SIZE [--curvature N] [--obj FILE] [--program GMSH] [--threads N]

At one uniform size; with N, also with N elements around a full turn. FILE gets the mesh. By Debian's Python module, or by
the program GMSH of any build, which says how many seconds of the processor meshing took. Prints one line of JSON like the other drivers. A process of its own, so that nothing of AF2 is
linked with Gmsh.
"""

import argparse
import json
import re
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy

FRONTAL_DELAUNAY = 6


def options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("model")
    parser.add_argument("size", type=float)
    parser.add_argument("--curvature", type=float, default=0)
    parser.add_argument("--obj")
    parser.add_argument("--program")
    parser.add_argument("--threads", type=int, default=1)
    return parser.parse_args()


def by_program(chosen: argparse.Namespace) -> tuple:
    """Seconds of meshing edges and faces, and the triangles."""
    with tempfile.TemporaryDirectory() as folder:
        mesh = Path(folder) / "mesh.msh"
        sizes = (["-setnumber", "Mesh.MeshSizeFromCurvature", repr(chosen.curvature)] if chosen.curvature
                 else ["-clmin", repr(chosen.size)])
        done = subprocess.run([chosen.program, chosen.model, "-2", "-algo", "front2d", "-nt", str(chosen.threads), "-clmax",
                               repr(chosen.size), *sizes, "-format", "msh22", "-o", str(mesh)], capture_output=True,
                              text=True, check=True)
        said = re.findall(r"Done meshing [12]D \(Wall ([0-9.e-]+)s, CPU ([0-9.e-]+)s", done.stdout + done.stderr)
        return sum(float(cpu if chosen.threads == 1 else wall) for wall, cpu in said), *triangles_of_msh2(mesh)


def triangles_of_msh2(path: Path) -> tuple:
    """Points by tag, and the tags of the corners, of a text file of version 2.2."""
    lines = iter(path.read_text().splitlines())
    sections = {}
    for line in lines:
        if line in ("$Nodes", "$Elements"):
            sections[line] = [next(lines).split() for _ in range(int(next(lines)))]
    points = numpy.zeros((max(int(row[0]) for row in sections["$Nodes"]) + 1, 3))
    for tag, *place in sections["$Nodes"]:
        points[int(tag)] = [float(x) for x in place]
    corners = [[int(v) for v in row[3 + int(row[2]):]] for row in sections["$Elements"] if row[1] == "2"]
    return points, numpy.array(corners)


def by_module(chosen: argparse.Namespace) -> tuple:
    import gmsh

    return mesh(gmsh, chosen.model, chosen.size, chosen.curvature, chosen.threads), *triangles(gmsh)


def mesh(gmsh, model: str, size: float, curvature: float, threads: int) -> float:
    """Meshes edges and faces; user seconds spent on that, without reading the file."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("General.NumThreads", threads)
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


def triangles(gmsh) -> tuple:
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
    seconds, points, corners = by_program(chosen) if chosen.program else by_module(chosen)
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
