#!/usr/bin/python3
"""Draws a surface mesh: draw_mesh.py MESH PICTURE.png [--azimuth A] [--elevation E]

Needs Debian's python3-meshio, python3-matplotlib and python3-pil. Elements that face the viewer are drawn from
back to front, one colour for each face of the model.
"""
import argparse

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import meshio
import numpy as np
from matplotlib.collections import PolyCollection
from PIL import Image

PALETTE = np.array([plt.get_cmap("Pastel1")(i)[:3] for i in (1, 2, 3, 4, 6, 8)])
LIGHT = np.array([-0.35, 0.45, 0.82])


def camera(azimuth, elevation):
    """Rows: to the right, up, towards the viewer."""
    a, e = np.radians(azimuth), np.radians(elevation)
    right = [-np.sin(a), np.cos(a), 0]
    viewer = [np.cos(a) * np.cos(e), np.sin(a) * np.cos(e), np.sin(e)]
    return np.array([right, np.cross(viewer, right), viewer])


def visible_polygons(mesh, view):
    points = mesh.points @ view.T
    for block, faces in zip(mesh.cells, mesh.cell_data["face"]):
        corners = points[block.data]
        normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normal /= np.linalg.norm(normal, axis=1, keepdims=True)
        for polygon, n, face in zip(corners, normal, faces):
            if n[2] > 0:
                yield polygon[:, 2].mean(), polygon[:, :2], n, int(face)


def main():
    options = argparse.ArgumentParser()
    options.add_argument("mesh")
    options.add_argument("picture")
    options.add_argument("--azimuth", type=float, default=30)
    options.add_argument("--elevation", type=float, default=28)
    chosen = options.parse_args()

    view = camera(chosen.azimuth, chosen.elevation)
    polygons = sorted(visible_polygons(meshio.read(chosen.mesh), view), key=lambda p: p[0])
    brightness = [0.72 + 0.28 * max(0, n @ LIGHT) for _, _, n, _ in polygons]
    colours = [PALETTE[face % len(PALETTE)] * b for (*_, face), b in zip(polygons, brightness)]

    figure, axes = plt.subplots(figsize=(5, 5), dpi=110)
    axes.add_collection(
        PolyCollection([p for _, p, _, _ in polygons], facecolors=colours, edgecolors="#303030", linewidths=0.25)
    )
    axes.autoscale_view()
    axes.set_aspect("equal")
    axes.axis("off")
    figure.savefig(chosen.picture, bbox_inches="tight", pad_inches=0.02)
    Image.open(chosen.picture).convert("RGB").quantize(128).save(chosen.picture, optimize=True)


if __name__ == "__main__":
    main()
