"""A surface that is a Python class: AF2 asks it for positions and normals.

Run it anywhere: PYTHONPATH=build/python /usr/bin/python3 examples/python/own_surface.py

Writes: shell.vtu
"""

import numpy as np

import af2


class Shell:
    """A wavy shell over the rectangle [0, 6] x [0, 4]."""

    bounds = ((0, 6), (0, 4))

    def evaluate(self, uv):
        u, v = uv.T
        return np.column_stack([u, v, 0.4 * np.sin(u) * np.cos(v)])

    def normal(self, uv):
        u, v = uv.T
        return np.column_stack([-0.4 * np.cos(u) * np.cos(v), 0.4 * np.sin(u) * np.sin(v), np.ones(len(uv))])


turn = np.linspace(0, 2 * np.pi, 16, endpoint=False)[::-1]  # holes run clockwise
hole = [3, 2] + 0.8 * np.column_stack([np.cos(turn), np.sin(turn)])
surface = af2.Surface(Shell(), loops=[[(0, 0), (6, 0), (6, 4), (0, 4)], hole])

mesh = af2.mesh(surface, size=0.3)
print(mesh)
x, y, z = mesh.points.T
assert np.allclose(z, 0.4 * np.sin(x) * np.cos(y))
mesh.write("shell.vtu")
