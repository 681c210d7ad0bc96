"""Sizes from a NumPy function of the position, with progress and a fixed number of threads.

Run it in the folder of the repository: PYTHONPATH=build/python /usr/bin/python3 examples/python/sizes_from_a_function.py

Writes: fine_corner.vtu
"""

import os
import pathlib

import numpy as np

import af2

MODELS = pathlib.Path(os.environ.get("AF2_MODELS", "examples/models"))

model = af2.read(MODELS / "brickhole.step")
corner = np.array(model.parts().edges[0].start)


def sizes(points):
    """Grows with the distance from a corner: points has the shape (n, 3), and n sizes come back."""
    return 0.1 + 0.3 * np.linalg.norm(points - corner, axis=1)


def progress(state):
    print(f"\r{100 * state.fraction:3.0f} %, {state.elements} elements", end="")


mesh = af2.mesh(model, size=1.5, sizes=sizes, threads=2, progress=progress)
print(f"\n{mesh}")

# How well do the edges have the lengths that were asked for?
sides = mesh.points[mesh.triangles]
lengths = np.linalg.norm(sides - np.roll(sides, -1, axis=1), axis=2).mean(axis=1)
wanted = np.minimum(1.5, sizes(sides.mean(axis=1)))
print(f"length / wanted size: median {np.median(lengths / wanted):.2f}")
mesh.write("fine_corner.vtu")
