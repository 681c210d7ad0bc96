"""A planar domain with a hole, made of arrays; a heat equation on its mesh, solved with NumPy alone.

The outer boundary has the temperature 0, the hole has 1. Linear elements; conjugate gradients on the arrays.

Run it anywhere: PYTHONPATH=build/python /usr/bin/python3 examples/python/heat_in_a_plate.py

Writes: heat.csv
"""

import numpy as np

import af2

turn = np.linspace(0, 2 * np.pi, 64, endpoint=False)
circle = np.column_stack([np.cos(turn), np.sin(turn)])
mesh = af2.mesh(af2.Planar(3 * circle, holes=[circle]), size=0.2, threads=1)
x = mesh.points[:, :2]
triangles = mesh.triangles

# Gradients of the three basis functions of each triangle.
a, b, c = (x[triangles[:, i]] for i in range(3))
area = 0.5 * np.cross(b - a, c - a)
edges = np.stack([c - b, a - c, b - a], axis=1)  # (m, 3, 2), opposite to each corner
gradients = np.stack([-edges[..., 1], edges[..., 0]], axis=2) / (2 * area)[:, None, None]
stiffness = np.einsum("mik,mjk,m->mij", gradients, gradients, area)


def apply(u):
    """The stiffness matrix times u, element by element."""
    local = np.einsum("mij,mj->mi", stiffness, u[triangles])
    result = np.zeros_like(u)
    np.add.at(result, triangles, local)
    return result


# Points on the boundary: the ends of its segments. Edges of the hole come after the 64 of the outer polygon.
is_hole = mesh.segment_edges > 64
inner, outer = (np.unique(mesh.segments[chosen]) for chosen in (is_hole, ~is_hole))
free = np.ones(len(x), dtype=bool)
free[inner] = free[outer] = False

u = np.zeros(len(x))
u[inner] = 1
residual = np.where(free, -apply(u), 0)
direction, steps = residual.copy(), 0
while np.linalg.norm(residual) > 1e-10:
    product = np.where(free, apply(direction), 0)
    alpha = residual @ residual / (direction @ product)
    u += alpha * direction
    new = residual - alpha * product
    direction = new + (new @ new / (residual @ residual)) * direction
    residual, steps = new, steps + 1

exact = 1 - np.log(np.linalg.norm(x, axis=1)) / np.log(3)  # between circles
error = np.abs(u - exact).max()
print(f"{len(triangles)} triangles, {steps} steps; largest error {error:.4f}")
assert error < 0.02 and 0 <= u.min() and u.max() <= 1
np.savetxt("heat.csv", np.column_stack([x, u]), delimiter=",", header="x,y,temperature", comments="")
