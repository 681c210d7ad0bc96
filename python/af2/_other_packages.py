"""Meshes of other packages, which need not be installed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict

import numpy as np

if TYPE_CHECKING:
    from ._mesh import Mesh

#: Arrays that elements have in other packages, too.
_CELL_DATA = ("face", "rule", "level", "quality")
_MESHIO_NAMES = {(3, 1): "triangle", (4, 1): "quad", (3, 2): "triangle6", (4, 2): "quad8"}
_VTK_TYPES = {(3, 1): 5, (4, 1): 9, (3, 2): 22, (4, 2): 23}


def meshio_of(mesh: "Mesh") -> Any:
    try:
        import meshio
    except ImportError:
        raise ImportError("to_meshio needs meshio; install it, for example with: apt install python3-meshio") from None
    is_quad = mesh.is_quad
    blocks, chosen = [], []
    for kind, which in ((3, ~is_quad), (4, is_quad)):
        if which.any():
            blocks.append((_MESHIO_NAMES[kind, mesh.order], _cells(mesh, kind, which)))
            chosen.append(which)
    data = {name: [getattr(mesh, name)[which] for which in chosen] for name in _CELL_DATA}
    sets = {group.label: [np.flatnonzero(np.isin(mesh.face[which], group.faces)) for which in chosen]
            for group in mesh.groups if group.faces}
    return meshio.Mesh(mesh.points, blocks, cell_data=data, cell_sets=sets)


def pyvista_of(mesh: "Mesh") -> Any:
    try:
        import pyvista
    except ImportError:
        raise ImportError("to_pyvista needs PyVista; install it, for example with: pip install pyvista") from None
    is_quad = mesh.is_quad
    cells: Dict[int, np.ndarray] = {}
    for kind, which in ((3, ~is_quad), (4, is_quad)):
        if which.any():
            cells[_VTK_TYPES[kind, mesh.order]] = np.ascontiguousarray(_cells(mesh, kind, which))
    grid = pyvista.UnstructuredGrid(cells, np.asarray(mesh.points))
    order = np.concatenate([np.flatnonzero(~is_quad), np.flatnonzero(is_quad)])
    for name in _CELL_DATA:
        grid.cell_data[name] = np.asarray(getattr(mesh, name))[order]
    return grid


def _cells(mesh: "Mesh", corners: int, which: np.ndarray) -> np.ndarray:
    if mesh.order == 1:
        return mesh.triangles if corners == 3 else mesh.quads
    return np.hstack([mesh.elements[which, :corners], mesh.midsides[which, :corners]])
