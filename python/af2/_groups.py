"""Faces or edges of a model that belong together, and the elements on them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, List

import numpy as np

if TYPE_CHECKING:
    from ._mesh import Mesh


class Group:
    """Faces of the model that belong together, or edges (kind "boundary"), with their elements or segments.

    Attributes:
        name: of the group.
        kind: "part", "solid", "layer", "color", "interface" or "boundary".
        faces: ids of its faces; empty for a boundary.
        inward: of a solid: ids of those faces whose elements look into it.
        edges: ids of its edges, for a boundary.
        number: of a boundary; else 0.
    """

    def __init__(self, mesh: "Mesh", group: Any):
        self._mesh = mesh
        self.name: str = group.name
        self.kind: str = getattr(group, "kind", "boundary")
        self.faces: List[int] = getattr(group, "faces", [])
        self.inward: List[int] = getattr(group, "inward", [])
        self.edges: List[int] = getattr(group, "edges", [])
        self.number: int = getattr(group, "number", 0)

    @property
    def label(self) -> str:
        """The name in mesh files: "inlet" for a part, "solid 1" for the solid "1"."""
        is_plain = self.kind in ("solid", "color") or self.name == str(self.number)
        return f"{self.kind} {self.name}" if is_plain else self.name

    @property
    def elements(self) -> np.ndarray:
        """Indices of the elements on its faces, ascending."""
        return np.flatnonzero(np.isin(self._mesh.face, self.faces))

    @property
    def segments(self) -> np.ndarray:
        """(n, 2) points of the segments along its edges, for a boundary."""
        return self._mesh.segments[np.isin(self._mesh.segment_edges, self.edges)]

    def __repr__(self) -> str:
        parts = f"{len(self.edges)} edges" if self.kind == "boundary" else f"{len(self.faces)} faces"
        return f"<af2.Group {self.kind} '{self.name}': {parts}>"
