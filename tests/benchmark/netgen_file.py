#!/usr/bin/python3
"""Meshes a CAD file with Netgen's Python module, for comparison: from the file to a file.

    PYTHON netgen_file.py MODEL SIZE FILE.obj [--curvature N] [--least SIZE] [--threads N]

PYTHON is one that has the module netgen, of a version since 6.2.2004: Debian's older one ignores the size of CAD models
(netgen_driver is for that). Prints one line of JSON: triangles, threads, and the wall and processor seconds of the mesher alone, from the shape in memory to the surface mesh.
"""

import argparse
import contextlib
import json
import math
import sys
import time

from netgen import meshing

try:
    from netgen.occ import OCCGeometry
except ImportError:
    sys.exit("this version of Netgen ignores the size of CAD models; use netgen_driver, or a newer one")


def options():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("model")
    parser.add_argument("size", type=float)
    parser.add_argument("file")
    parser.add_argument("--curvature", type=float, default=12, help="elements around a full turn")
    parser.add_argument("--least", type=float, default=0)
    parser.add_argument("--threads", type=int, default=1)
    return parser.parse_args()


def with_threads(count):
    """What Netgen's parallel parts need, and how many threads they have."""
    try:
        from pyngcore import SetNumThreads, TaskManager
    except ImportError:
        return contextlib.nullcontext(), 1
    SetNumThreads(count)
    return TaskManager(), count


def settings(chosen):
    found = {"maxh": chosen.size, "curvaturesafety": chosen.curvature / (2 * math.pi),
             "perfstepsend": meshing.MeshingStep.MESHSURFACE}
    return {**found, "minh": chosen.least} if chosen.least > 0 else found


def write(mesh, path):
    lines = ["v " + " ".join(repr(x) for x in point.p) for point in mesh.Points()]
    faces = [[vertex.nr for vertex in element.vertices] for element in mesh.Elements2D()]
    lines += ["f " + " ".join(map(str, face)) for face in faces]
    with open(path, "w") as file:
        file.write("\n".join(lines) + "\n")
    return len(faces)


def main():
    chosen = options()
    shape = OCCGeometry(chosen.model)
    parallel, threads = with_threads(chosen.threads)
    with parallel:
        wall, processor = time.perf_counter(), time.process_time()
        mesh = shape.GenerateMesh(**settings(chosen))
        wall, processor = time.perf_counter() - wall, time.process_time() - processor
    triangles = write(mesh, chosen.file)
    print(json.dumps({"triangles": triangles, "threads": threads, "wall": wall, "processor": processor}))
    return 0 if triangles else 1


if __name__ == "__main__":
    sys.exit(main())
