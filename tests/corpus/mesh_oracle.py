"""Looks at a mesh with nothing but its file: is it closed, free of folds and of intersections?

Shares no code with AF2, so that it can hold AF2's own checks to account. Needs NumPy.
"""

import base64
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

# Triangles that reach into each other by less than this share of the model's diagonal touch.
DEPTH = 1e-9
# Two triangles at a common edge lie on each other if the angle between them is below this.
FOLD_DEGREES = 0.3


@dataclass
class Mesh:
    points: np.ndarray  # n x 3
    triangles: np.ndarray  # m x 3; quadrilaterals come in two halves
    faces: np.ndarray  # by triangle: number of the model's face
    cells: list  # triangles, then quadrilaterals: their corners, their faces


@dataclass
class Findings:
    min_angle: float  # in degrees, at the corners of the elements
    open_edges: int  # with one triangle
    multiple_edges: int  # with more than two
    turned_edges: int  # two triangles of one face in the same direction
    folds: int  # pairs of triangles with a common edge, one lying on the other
    intersections: int  # pairs of triangles that belong to the same piece of the mesh
    between_pieces: int  # pairs of triangles of pieces without a common vertex, e.g. parts that touch
    examples: list  # some of the intersections: a place and the two faces
    area: dict  # by face


def _array(text: str, name: str, dtype) -> np.ndarray:
    found = re.search(rf'<DataArray[^>]*Name="{name}"[^>]*>\s*([^<]*?)\s*</DataArray>', text)
    raw = base64.b64decode(found.group(1))
    return np.frombuffer(raw, dtype=dtype, offset=8)


def read_vtu(path: Path) -> Mesh:
    text = path.read_text()
    points = _array(text, "Points", "<f8").reshape(-1, 3)
    corners = _array(text, "connectivity", "<i4")
    ends = _array(text, "offsets", "<i8")
    face = _array(text, "face", "<i4")
    starts = np.concatenate(([0], ends[:-1]))
    is_quad = (ends - starts) == 4
    a, b, c = (corners[starts + k] for k in range(3))
    triangles = np.stack([a, b, c], 1)
    quads = starts[is_quad]
    second = np.stack([corners[quads], corners[quads + 2], corners[quads + 3]], 1)
    whole = np.stack([corners[quads + k] for k in range(4)], 1)
    cells = [(triangles[~is_quad], face[~is_quad]), (whole, face[is_quad])]
    return Mesh(points, np.concatenate([triangles, second]), np.concatenate([face, face[is_quad]]),
                cells)


def _min_angle(mesh: Mesh) -> float:
    least = 180.0
    for corners, _ in mesh.cells:
        p = mesh.points[corners]
        if not len(p):
            continue
        ahead = np.roll(p, -1, axis=1) - p
        behind = np.roll(p, 1, axis=1) - p
        sine = np.linalg.norm(np.cross(ahead, behind), axis=2)
        cosine = np.einsum("ijk,ijk->ij", ahead, behind)
        least = min(least, float(np.degrees(np.arctan2(sine, cosine)).min()))
    return least


def _edges(mesh: Mesh):
    """Directed edges of the elements: low end, high end, whether low to high, model face."""
    ends, faces = [], []
    for corners, face in mesh.cells:
        for k in range(corners.shape[1]):
            ends.append(np.stack([corners[:, k], np.roll(corners, -1, axis=1)[:, k]], 1))
            faces.append(face)
    ends = np.concatenate(ends)
    return ends.min(axis=1), ends.max(axis=1), ends[:, 0] < ends[:, 1], np.concatenate(faces)


def _count_edges(mesh: Mesh) -> tuple:
    low, high, forward, face = _edges(mesh)
    order = np.lexsort((high, low))
    low, high, forward, face = low[order], high[order], forward[order], face[order]
    starts = np.flatnonzero(np.concatenate(([True], (low[1:] != low[:-1]) | (high[1:] != high[:-1]))))
    counts = np.diff(np.concatenate((starts, [len(low)])))
    pairs = starts[counts == 2]
    turned = (forward[pairs] == forward[pairs + 1]) & (face[pairs] == face[pairs + 1])
    return int((counts == 1).sum()), int((counts > 2).sum()), int(turned.sum())


def _boxes(low: np.ndarray, high: np.ndarray) -> list:
    """A binary tree over boxes in a row: level k has 2^k of them, the last level the boxes."""
    levels = [(low, high)]
    while len(low) > 1:
        low = np.minimum(low[0::2], low[1::2])
        high = np.maximum(high[0::2], high[1::2])
        levels.append((low, high))
    return levels[::-1]


def _along_curve(centres: np.ndarray) -> np.ndarray:
    """An order in which neighbours in space mostly are neighbours in the row."""
    low, high = centres.min(axis=0), centres.max(axis=0)
    cells = ((centres - low) / np.maximum(high - low, 1e-300) * 1023).astype(np.int64)
    code = np.zeros(len(centres), dtype=np.int64)
    for bit in range(10):
        for axis in range(3):
            code |= ((cells[:, axis] >> bit) & 1) << (3 * bit + axis)
    return np.argsort(code, kind="stable")


def _near_pairs(corners: np.ndarray, gap: float):
    """Chunks of pairs (i, j), i < j, of triangles whose boxes overlap."""
    order = _along_curve(corners.mean(axis=1))
    count = len(order)
    size = 1 << max(count - 1, 0).bit_length()
    low = np.full((size, 3), np.inf)
    high = np.full((size, 3), -np.inf)
    low[:count] = corners[order].min(axis=1) - gap
    high[:count] = corners[order].max(axis=1) + gap
    levels = _boxes(low, high)
    work = [(0, np.zeros(1, dtype=np.int64), np.zeros(1, dtype=np.int64))]
    while work:
        level, i, j = work.pop()
        if level == len(levels) - 1:
            keep = i < j
            yield order[i[keep]], order[j[keep]]
            continue
        same = i == j
        i2 = np.concatenate([2 * i, 2 * i, 2 * i + 1, 2 * i[~same] + 1])
        j2 = np.concatenate([2 * j, 2 * j + 1, 2 * j + 1, 2 * j[~same]])
        lows, highs = levels[level + 1]
        overlap = np.all((lows[i2] <= highs[j2]) & (lows[j2] <= highs[i2]), axis=1)
        i2, j2 = i2[overlap], j2[overlap]
        for part in range(0, len(i2), 200_000):
            work.append((level + 1, i2[part:part + 200_000], j2[part:part + 200_000]))


def _unit(vectors: np.ndarray) -> np.ndarray:
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return np.where(length > 0, vectors / np.where(length > 0, length, 1), 0)


def _reach_into_each_other(p: np.ndarray, q: np.ndarray, depth: float) -> np.ndarray:
    """Which pairs of triangles no plane separates: n x 3 x 3 corners each."""
    centre = (p + q).mean(axis=1, keepdims=True) / 2
    p, q = p - centre, q - centre
    edges_p, edges_q = np.roll(p, -1, axis=1) - p, np.roll(q, -1, axis=1) - q
    normal_p = _unit(np.cross(edges_p[:, 0], edges_p[:, 1]))
    normal_q = _unit(np.cross(edges_q[:, 0], edges_q[:, 1]))
    axes = [normal_p, normal_q]
    axes += [_unit(np.cross(normal_p, edges_p[:, k])) for k in range(3)]
    axes += [_unit(np.cross(normal_q, edges_q[:, k])) for k in range(3)]
    for a in range(3):
        for b in range(3):
            axes.append(_unit(np.cross(_unit(edges_p[:, a]), _unit(edges_q[:, b]))))
    meets = np.ones(len(p), dtype=bool)
    flat = (np.abs(np.einsum("ijk,ik->ij", q - p[:, :1], normal_p)).max(axis=1) <= depth)
    for k, axis in enumerate(axes):
        valid = np.linalg.norm(axis, axis=1) > 0.5
        on_p = np.einsum("ijk,ik->ij", p, axis)
        on_q = np.einsum("ijk,ik->ij", q, axis)
        reach = np.minimum(on_p.max(axis=1) - on_q.min(axis=1), on_q.max(axis=1) - on_p.min(axis=1))
        separates = valid & (reach <= depth)
        if k < 2:
            separates &= ~flat  # in one plane: only directions in the plane can tell
        if k >= 8:
            separates &= ~flat
        meets &= ~separates
    return meets


def _pieces(mesh: Mesh) -> np.ndarray:
    """By triangle: the lowest vertex of the piece that it hangs together with."""
    lowest = np.arange(len(mesh.points))
    while True:
        least = lowest[mesh.triangles].min(axis=1)
        before = lowest.copy()
        np.minimum.at(lowest, mesh.triangles.ravel(), np.repeat(least, 3))
        lowest = lowest[lowest]
        if np.array_equal(before, lowest):
            return lowest[mesh.triangles[:, 0]]


def _intersections(mesh: Mesh, depth: float) -> tuple:
    corners = mesh.points[mesh.triangles]
    piece = _pieces(mesh)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    count, between, folds, examples = 0, 0, 0, []
    for i, j in _near_pairs(corners, depth):
        common = (mesh.triangles[i][:, :, None] == mesh.triangles[j][:, None, :]).sum(axis=(1, 2))
        apart = common < 2
        meets = np.zeros(len(i), dtype=bool)
        meets[apart] = _reach_into_each_other(corners[i[apart]], corners[j[apart]], depth)
        same = piece[i] == piece[j]
        between += int((meets & ~same).sum())
        meets &= same
        count += int(meets.sum())
        for a, b in zip(i[meets][:3], j[meets][:3]):
            if len(examples) < 12:
                examples.append([[float(x) for x in corners[a].mean(axis=0)],
                                 int(mesh.faces[a]), int(mesh.faces[b])])
        folds += _folds(mesh, normals, i[common == 2], j[common == 2])
        folds += int((common == 3).sum())
    return count, between, folds, examples


def _folds(mesh: Mesh, normals: np.ndarray, i: np.ndarray, j: np.ndarray) -> int:
    if not len(i):
        return 0
    shared = (mesh.triangles[i][:, :, None] == mesh.triangles[j][:, None, :])
    lone_i = mesh.triangles[i][np.arange(len(i)), np.argmin(shared.any(axis=2), axis=1)]
    lone_j = mesh.triangles[j][np.arange(len(j)), np.argmin(shared.any(axis=1), axis=1)]
    k = np.argmax(shared.any(axis=2), axis=1)
    both = shared.any(axis=2)
    first = mesh.triangles[i][np.arange(len(i)), k]
    last = mesh.triangles[i][np.arange(len(i)), 2 - np.argmax(both[:, ::-1], axis=1)]
    along = _unit(mesh.points[last] - mesh.points[first])

    def across(lone):
        d = mesh.points[lone] - mesh.points[first]
        return _unit(d - np.einsum("ij,ij->i", d, along)[:, None] * along)

    cosine = np.einsum("ij,ij->i", across(lone_i), across(lone_j))
    return int((cosine > np.cos(np.radians(FOLD_DEGREES))).sum())


def examine(path: Path) -> Findings:
    mesh = read_vtu(path)
    corners = mesh.points[mesh.triangles]
    doubled = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]),
                             axis=1)
    area = {}
    for face in np.unique(mesh.faces):
        area[int(face)] = float(doubled[mesh.faces == face].sum() / 2)
    diagonal = float(np.linalg.norm(mesh.points.max(axis=0) - mesh.points.min(axis=0)))
    open_edges, multiple, turned = _count_edges(mesh)
    count, between, folds, examples = _intersections(mesh, DEPTH * diagonal)
    return Findings(_min_angle(mesh), open_edges, multiple, turned, folds, count, between, examples,
                    area)


if __name__ == "__main__":
    import sys

    for name in sys.argv[1:]:
        print(name, examine(Path(name)))
