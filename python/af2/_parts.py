"""Parts of a mesh, for programs that run in many processes."""

from __future__ import annotations

import operator
from dataclasses import dataclass
from typing import Any, List

import numpy as np

from . import _af2


@dataclass(frozen=True, eq=False, repr=False)
class Part:
    """What one process of a parallel program needs of a mesh: its own elements, and those beside them.

    Each element belongs to one part, and each point to the lowest of those that have an element with it. A part also has
    the elements of others that share a point with its own: its ghosts. What the part owns comes first in all arrays.

    Indices count from 0 within the part. Ids are those of the whole mesh: row `point_ids[i]` of `Mesh.points`. Numbers
    count from 0 in the whole mesh, too, but such that each part owns consecutive ones, as PETSc and others want it.
    """

    part: int  #: its number, from 0
    parts: int  #: how many there are
    points: np.ndarray  #: (n, 3) float64
    owned_points: int
    point_ids: np.ndarray  #: (n,) int64
    point_numbers: np.ndarray  #: (n,) int64
    point_owners: np.ndarray  #: (n,) int32: parts
    elements: np.ndarray  #: (m, 4) int32: indices of corners; [3] is -1 for triangles
    owned_elements: int
    element_ids: np.ndarray  #: (m,) int64
    element_numbers: np.ndarray  #: (m,) int64
    element_owners: np.ndarray  #: (m,) int32: parts
    face: np.ndarray  #: (m,) int32: ids of the faces of the model
    midsides: np.ndarray  #: (m, 4) int32 with order=2, else (0, 4)
    ghosts_begin: np.ndarray  #: (owned_elements + 1,) int64: see ghosts_of
    #: int32: own element e is a ghost of the parts ghosts_of[ghosts_begin[e]:ghosts_begin[e + 1]].
    ghosts_of: np.ndarray
    lines: np.ndarray  #: (k, 3) int32: ends and middle of the own segments along edges; [2] is -1 unless order=2
    line_ids: np.ndarray  #: (k,) int64: among the lines of the whole mesh
    line_edges: np.ndarray  #: (k,) int32: ids of the edges of the model

    def __repr__(self) -> str:
        ghosts = len(self.elements) - self.owned_elements
        return f"<af2.Part {self.part} of {self.parts}: {self.owned_elements} elements, {ghosts} ghosts>"


def divided(mesh: Any, count: int, edges: bool) -> List[Part]:
    """See Mesh.parts."""
    if operator.index(count) < 1:
        raise _af2.InputError(f"count must be at least 1, not {count}")
    return [Part(**fields) for fields in _af2.parts(mesh, operator.index(count), bool(edges))]
