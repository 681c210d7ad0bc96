"""What can be meshed: files, bytes, arrays, shapes of other packages, and surfaces that Python code gives."""

from __future__ import annotations

import os
import tempfile
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _af2
from ._shapes import brep_of


class Model:
    """A model that was read, to be meshed any number of times. Immutable: threads may mesh it at once.

    Make it with `af2.read`, `af2.Planar`, `af2.Triangles` or `af2.Surface`.
    """

    def __init__(self, handle: Any, name: str):
        self._handle = handle
        self.name = name

    @property
    def kind(self) -> str:
        """"cad", "planar", "triangles" or "surface"."""
        return self._handle.kind

    @property
    def notes(self) -> List[str]:
        """Repairs that were made while reading, and oddities; one sentence each."""
        return self._handle.notes

    @property
    def unit(self) -> str:
        """The unit of all lengths: "mm" from STEP and IGES; empty if the model does not say it."""
        return self._handle.unit

    @property
    def file_unit(self) -> str:
        """The unit in the file, as it is named there; empty if it has none."""
        return self._handle.file_unit

    def parts(self, size: Optional[float] = None) -> Any:
        """The faces, edges, groups and boundaries of the model, as `af2 inspect` lists them.

        Args:
            size: wanted edge length. Faces of planar domains and of surfaces of triangles depend on it, because details
                that no mesh of this size can show are left out; for CAD models it does not matter. By default a
                hundredth of the extent.

        Returns:
            An object with `faces` (each with `id`, `name`, `surface`, `area`, `edges`), `edges` (`id`, `curve`,
            `length`, `start`, `end`, `faces`), `groups` (`kind`, `name`, `faces`) and `boundaries` (`number`, `name`,
            `edges`).
        """
        return self._handle.parts(float(size or 0))

    def named(self, names: Mapping[str, Any]) -> "Model":
        """The same CAD model with names for its faces, for sizes and for groups in files: shapes of other packages come
        without names.

        Args:
            names: by name, the id of a face or a list of ids. The name of a single face becomes that of the face; several
                faces become a group.

        Raises:
            InputError: there is no such face, or this is no CAD model.
        """
        faces = [(name, [int(i) for i in np.atleast_1d(np.asarray(ids, dtype=np.int64))]) for name, ids in names.items()]
        return Model(self._handle.named(faces), self.name)

    def defects(self, size: Optional[float] = None) -> List[Any]:
        """What is wrong or awkward in the model for a mesh of this size: tiny edges, slivers, gaps, open loops, free
        edges, overlapping faces, ...; the most severe first.

        Args:
            size: wanted edge length; by default a hundredth of the extent.

        Returns:
            Objects with `kind`, `face`, `edge`, `vertex` (ids; 0: none), `extent`, `place`, `detail`.
        """
        return self._handle.defects(float(size or 0))

    def contacts(self) -> Any:
        """Where parts of a CAD model touch or overlap without sharing faces, so that meshes would not match there; see
        `imprint` of `af2.mesh`. Parts are compared in forked processes, because OpenCASCADE may crash over them.

        Returns:
            An object with `parts` (their number), `not_compared`, and `pairs`: each with `kind` ("touch", "overlap",
            "coincide", "unknown"), `parts` (two names), `area`, `length`, `volume`, `place`, `equal_faces` (pairs of
            ids).
        """
        return self._handle.contacts()

    def __repr__(self) -> str:
        return f"<af2.Model '{self.name}' ({self.kind})>"


def read(model: Any, names: Optional[Mapping[str, Any]] = None) -> Model:
    """Reads a model.

    Args:
        model: one of

            * a path to a STEP, IGES, BREP, STL, OBJ, .poly or .in2d file; the content tells the CAD formats apart;
            * bytes: the content of a STEP, IGES or BREP file;
            * a shape of FreeCAD, or an object of its documents
            * a shape of CadQuery (Workplane, Shape, Assembly), build123d (Shape, BuildPart), pythonocc or OCP
              (TopoDS_Shape), or Netgen (shapes and OCCGeometry). It is handed over as a BREP file in memory; its faces
              and edges keep their order;
            * a tuple of arrays: `(vertices, triangles)` of the shapes (n, 3) and (m, 3), or `(points, segments)` of
              the shapes (n, 2) and (m, 2): see `af2.Triangles` and `af2.Planar`;
            * an object with `evaluate(uv)`: see `af2.Surface`;
            * an `af2.Model`, which is returned as it is.
        names: names for faces of a CAD model, see `Model.named`.

    Raises:
        InputError: the model cannot be read; the text says why, and what to do.
        TypeError: it is none of these.
    """
    found = _found(model)
    return found.named(names) if names else found


def _found(model: Any) -> Model:
    if isinstance(model, Model):
        return model
    if isinstance(model, (str, os.PathLike)):
        path = os.fspath(model)
        return Model(_af2.read(path), os.path.basename(path))
    if isinstance(model, (bytes, bytearray, memoryview)):
        return _from_bytes(bytes(model), "<bytes>")
    if isinstance(model, tuple):
        return _from_arrays(model)
    if callable(getattr(model, "evaluate", None)):
        return Surface(model)
    content = brep_of(model)
    if content is None:
        raise TypeError(f"af2 cannot mesh an object of type {type(model).__module__}.{type(model).__qualname__}; give a "
                        "path, bytes, arrays, a shape of FreeCAD, CadQuery, build123d, pythonocc or Netgen, or a class with "
                        "evaluate(uv)")
    return _from_bytes(content, f"<{type(model).__name__}>")


def _from_bytes(content: bytes, name: str) -> Model:
    """The readers of OpenCASCADE take files, so the content goes through one that nobody else can see."""
    with tempfile.TemporaryDirectory(prefix="af2-") as folder:
        path = os.path.join(folder, "model")
        with open(path, "wb") as file:
            file.write(content)
        try:
            return Model(_af2.read(path), name)
        except _af2.InputError as error:
            raise _af2.InputError(str(error).replace(path, name)) from None


def _from_arrays(arrays: Tuple[Any, ...]) -> Model:
    if len(arrays) != 2:
        raise _af2.InputError(f"a tuple must have two arrays, not {len(arrays)}: vertices and triangles, or points and "
                              "segments")
    places, parts = np.asarray(arrays[0], dtype=float), np.asarray(arrays[1])
    if places.ndim == 2 and parts.ndim == 2:
        if (places.shape[1], parts.shape[1]) == (3, 3):
            return Triangles(places, parts)
        if (places.shape[1], parts.shape[1]) == (2, 2):
            return Planar(places, parts)
    raise _af2.InputError(f"arrays of the shapes {places.shape} and {parts.shape} are no model; a surface has (n, 3) "
                          "vertices and (m, 3) triangles, a planar domain (n, 2) points and (m, 2) segments")


def _indices(values: Any, columns: int, argument: str) -> np.ndarray:
    array = np.asarray(values)
    if array.ndim != 2 or array.shape[1] != columns or not (np.issubdtype(array.dtype, np.integer) or array.size == 0):
        raise _af2.InputError(f"{argument}: expected whole numbers of the shape (n, {columns}), not {array.dtype} of the "
                              f"shape {array.shape}")
    return np.ascontiguousarray(array, dtype=np.int64)


class Triangles(Model):
    """A surface that is given by triangles. AF2 finds its feature edges and makes new elements on it.

    Args:
        vertices: (n, 3) coordinates. Equal vertices are merged.
        triangles: (m, 3) indices of vertices, counted from 0, counter-clockwise seen from outside.
        parts: (m,) number of the part of each triangle, counted from 0; parts become groups.
        part_names: the names of the parts.
        name: of the model, for messages and files.

    Raises:
        InputError: an index is out of range, a coordinate is not finite, or no triangle is left after the repairs
            (see `Model.notes`).
    """

    def __init__(self, vertices: Any, triangles: Any, *, parts: Any = None, part_names: Optional[Sequence[str]] = None,
                 name: str = "triangles"):
        corners = _indices(triangles, 3, "triangles")
        numbers = _whole_numbers(parts, "parts")
        if len(numbers) and numbers.min() < 0:
            raise _af2.InputError("parts: numbers of parts are counted from 0")
        if len(numbers) and part_names is None:
            part_names = [f"part {i + 1}" for i in range(numbers.max() + 1)]
        places = np.asarray(vertices, dtype=float)
        super().__init__(
            _af2.triangles({"name": name, "vertices": places, "triangles": corners, "parts": numbers,
                            "part_names": list(part_names or [])}), name)


class Planar(Model):
    """A planar domain between straight segments.

    Args:
        points: (n, 2) coordinates.
        segments: (m, 2) indices of points, counted from 0. Without them, the points are the corners of a polygon, in
            order.
        holes: polygons that are cut out, each an array of (k, 2) coordinates, k >= 3.
        hole_points: (k, 2) points: regions between the segments that have one inside are left out.
        regions: names of regions: `{"copper": (x, y)}`, or `{"copper": [(x, y), ...]}`, with points inside. They become
            groups of faces.
        region_sizes: wanted edge lengths in such regions, by name.
        markers: (m,) number of the boundary to which each segment belongs; 0: none.
        boundary_names: names of these boundaries, by number.
        name: of the model, for messages and files.

    Segments inside the domain are kept as edges of the mesh. Segment i is edge i + 1 of the model; those of `holes` come
    after all others.

    Raises:
        InputError: an index is out of range or a coordinate is not finite. Segments that cross, or enclose nothing, are
            reported when the domain is meshed.
    """

    def __init__(self, points: Any, segments: Any = None, *, holes: Sequence[Any] = (), hole_points: Any = (),
                 regions: Optional[Mapping[str, Any]] = None, region_sizes: Optional[Mapping[str, float]] = None,
                 markers: Any = None, boundary_names: Optional[Mapping[int, str]] = None, name: str = "planar"):
        places = [_polygon(points, "points")]
        ends = [_around(len(places[0]), 0) if segments is None else _indices(segments, 2, "segments")]
        inside = [np.asarray(hole_points, dtype=float).reshape(-1, 2)]
        for hole in holes:
            polygon = _polygon(hole, "holes")
            ends.append(_around(len(polygon), sum(map(len, places))))
            places.append(polygon)
            inside.append(_point_inside(polygon)[np.newaxis])
        segments = np.concatenate(ends)
        numbers = _markers(markers, len(ends[0]), len(segments))
        domain_points, names, sizes = _regions(regions or {}, region_sizes or {})
        domain: Dict[str, Any] = {
            "name": name, "points": np.concatenate(places), "segments": segments,
            "markers": numbers, "marker_names": {int(k): v for k, v in (boundary_names or {}).items()},
            "holes": np.concatenate(inside), "regions": domain_points, "domain_names": names, "domain_sizes": sizes}
        super().__init__(_af2.planar(domain), name)


def _polygon(points: Any, argument: str) -> np.ndarray:
    array = np.asarray(points, dtype=float)
    if array.ndim != 2 or array.shape[1] != 2 or len(array) < 3:
        raise _af2.InputError(f"{argument}: expected at least three points, an array of the shape (n, 2), not "
                              f"{array.shape}")
    return array


def _around(count: int, first: int) -> np.ndarray:
    corners = np.arange(count, dtype=np.int64)
    return first + np.column_stack([corners, np.roll(corners, -1)])


def _point_inside(polygon: np.ndarray) -> np.ndarray:
    """In the middle of the first stretch, from the left, of a horizontal line that misses all corners."""
    heights = np.unique(polygon[:, 1])
    if len(heights) < 2:
        raise _af2.InputError("holes: the corners of a hole are on one line")
    widest = int(np.argmax(np.diff(heights)))
    y = 0.5 * (heights[widest] + heights[widest + 1])
    start, end = polygon, np.roll(polygon, -1, axis=0)
    crossed = (start[:, 1] > y) != (end[:, 1] > y)
    share = (y - start[crossed, 1]) / (end[crossed, 1] - start[crossed, 1])
    x = np.sort(start[crossed, 0] + share * (end[crossed, 0] - start[crossed, 0]))
    return np.array([0.5 * (x[0] + x[1]), y])


def _markers(markers: Any, given: int, count: int) -> np.ndarray:
    numbers = _whole_numbers(markers, "markers")
    if markers is not None and len(numbers) not in (given, count):
        raise _af2.InputError(f"markers: there are {len(numbers)} for {given} segments")
    return np.pad(numbers, (0, count - len(numbers))) if len(numbers) else numbers


def _whole_numbers(values: Any, argument: str) -> np.ndarray:
    """One for each part; none for None."""
    array = np.asarray([] if values is None else values)
    if array.ndim != 1 or not (np.issubdtype(array.dtype, np.integer) or array.size == 0):
        raise _af2.InputError(f"{argument}: expected a list of whole numbers")
    return array.astype(np.int64)


def _regions(regions: Mapping[str, Any], sizes: Mapping[str, float]) -> Tuple[np.ndarray, Dict[int, str], Dict[int, float]]:
    """One number for each point; regions with the same name become one group."""
    unknown = set(sizes) - set(regions)
    if unknown:
        raise _af2.InputError(f"region_sizes: there is no region {sorted(unknown)[0]!r} in regions")
    points: List[np.ndarray] = []
    names: Dict[int, str] = {}
    by_number: Dict[int, float] = {}
    for name, places in regions.items():
        for place in np.asarray(places, dtype=float).reshape(-1, 2):
            points.append(place)
            names[len(points)] = name
            if name in sizes:
                by_number[len(points)] = float(sizes[name])
    return np.array(points).reshape(-1, 2), names, by_number


class Surface(Model):
    """A surface that Python code gives by its parameters. Slow, because each answer is a call; meshes are as right as
    those of CAD models.

    Args:
        surface: an object with

            * `evaluate(uv)`: takes an array of (n, 2) parameters and returns (n, 3) positions;
            * `normal(uv)`, if it has one: takes the same and returns (n, 3) normals, of any length, towards the side
              from which elements are counter-clockwise. Without it, normals are du x dv;
            * `bounds`, unless they are given here;
            * `chart(start, end, length)`, if fronts are to run in charts of yours: see below.

            It may also be the function `evaluate` alone.
        bounds: `((u_low, u_high), (v_low, v_high))`; ((0, 1), (0, 1)) if neither is given. The surface must be smooth
            and one-to-one between them: cut closed surfaces open first.
        loops: boundaries in the parameters, each an array of (k, 2) corners with straight lines between them in the
            parameters; the outer loop counter-clockwise first, then holes clockwise. Without them, the whole of the
            bounds is meshed. The sides are the edges 1, 2, ... of the model.
        normal: the function `normal`, if `surface` is a function.
        name: of the model, for messages and files.

    A chart is a plane map of the surface around a base edge. `chart` gets the two ends of the edge, each as (position,
    normal, (u, v)), and the wanted edge length, which becomes 1 in the chart. It returns an object with
    `to_chart(points, normals, uv)`, which takes arrays of the shapes (n, 3), (n, 3) and (n, 2) and returns (n, 2) places,
    and `to_surface(places)`, which takes (n, 2) places and returns (n, 2) parameters, NaN where there are none. The start
    of the edge must be at (0, 0) and its end on the positive x axis; seen from the side of the normals, y is to its left.

    Raises:
        InputError: the bounds or loops are no such arrays. Errors of the functions are raised when the surface is
            meshed.
    """

    def __init__(self, surface: Any, bounds: Any = None, *, loops: Optional[Sequence[Any]] = None,
                 normal: Optional[Callable[[np.ndarray], Any]] = None, name: str = "surface"):
        evaluate = getattr(surface, "evaluate", surface)
        if not callable(evaluate):
            raise TypeError("a surface needs evaluate(uv), or must be such a function")
        bounds = bounds if bounds is not None else getattr(surface, "bounds", ((0, 1), (0, 1)))
        ranges = np.asarray(bounds, dtype=float)
        if ranges.shape != (2, 2) or not np.all(np.isfinite(ranges)) or np.any(ranges[:, 0] >= ranges[:, 1]):
            raise _af2.InputError("bounds: expected ((u_low, u_high), (v_low, v_high)) with low < high")
        (u0, u1), (v0, v1) = ranges
        if loops is None:
            loops = [[(u0, v0), (u1, v0), (u1, v1), (u0, v1)]]
        super().__init__(
            _af2.surface({"name": name, "evaluate": evaluate, "normal": normal or getattr(surface, "normal", None),
                          "chart": getattr(surface, "chart", None),
                          "u": (u0, u1), "v": (v0, v1), "loops": [_polygon(loop, "loops") for loop in loops]}), name)


ModelLike = Union[str, "os.PathLike[str]", bytes, Tuple[Any, Any], Model, Any]
