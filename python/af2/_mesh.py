"""A mesh: arrays over the memory of the C++ library, reports, files, and points of the model."""

from __future__ import annotations

import html
import os
import tempfile
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Union

import numpy as np

from . import _arguments, _other_packages
from ._groups import Group
from ._parts import Part, divided


class Snapped(NamedTuple):
    """Points of a model, one row for each point that was asked for."""

    points: np.ndarray  #: (n, 3) positions
    normals: np.ndarray  #: (n, 3) unit normals, towards the side from which elements are counter-clockwise
    faces: np.ndarray  #: (n,) ids of faces; 0: not known
    uv: np.ndarray  #: (n, 2) parameters of the faces: OpenCASCADE's for CAD models
    distances: np.ndarray  #: (n,) from the points that were asked for


class Mesh:
    """A mesh of triangles and quadrilaterals, as `af2.mesh` returns it. Immutable.

    Arrays are read-only views of the memory of the mesh, which they keep alive: nothing is copied. Only `triangles`
    and `quads` of a mesh that has both are made at the first request, because elements are stored together.
    """

    def __init__(self, data: Any, *, strict: bool = False, only_quads: bool = False):
        self._data = data
        self._report = data.mesh
        self._strict = strict
        self._only_quads = only_quads
        self._kinds: Optional[Dict[str, np.ndarray]] = None
        self._problems: Optional[List[str]] = None

    # Points and elements

    @property
    def points(self) -> np.ndarray:
        """(n, 3) float64: coordinates, in model units. With order=2, those at the middles of sides come last."""
        return self._data.points

    @property
    def elements(self) -> np.ndarray:
        """(m, 4) int32: corners, counter-clockwise seen from outside; [3] is -1 for triangles."""
        return self._data.elements

    @property
    def triangles(self) -> np.ndarray:
        """(t, 3) int32: corners of the triangles."""
        quads = self._data.quads
        if quads == 0:
            return self._data.first_corners
        return self._kind("triangles")

    @property
    def quads(self) -> np.ndarray:
        """(q, 4) int32: corners of the quadrilaterals."""
        if self._data.quads == len(self.elements):
            return self._data.elements
        return self._kind("quads")

    def _kind(self, name: str) -> np.ndarray:
        if self._kinds is None:
            corners = self.elements
            is_quad = corners[:, 3] >= 0
            kinds = {"triangles": np.ascontiguousarray(corners[~is_quad, :3]),
                     "quads": np.ascontiguousarray(corners[is_quad])}
            for array in kinds.values():
                array.flags.writeable = False
            self._kinds = kinds
        return self._kinds[name]

    @property
    def is_quad(self) -> np.ndarray:
        """(m,) bool: which elements are quadrilaterals."""
        return self.elements[:, 3] >= 0

    @property
    def order(self) -> int:
        """1 or 2."""
        return 2 if len(self._data.midsides) else 1

    @property
    def midsides(self) -> np.ndarray:
        """(m, 4) int32: with order=2, the points at the middles of the sides; [0] is between corners 0 and 1, and [3] of
        a triangle is -1. (0, 4) with order=1."""
        return self._data.midsides

    @property
    def straightened(self) -> np.ndarray:
        """Indices of elements of order 2 that kept straight sides, because curved ones would invert them."""
        return self._data.straightened

    @property
    def segments(self) -> np.ndarray:
        """(s, 2) int32: points at the ends of the pieces into which edges of the model are divided."""
        return self._data.segments

    @property
    def segment_edges(self) -> np.ndarray:
        """(s,) int32: id of the edge of the model to which each segment belongs."""
        return self._data.segment_edges

    @property
    def segment_uses(self) -> np.ndarray:
        """(s,) int32: how often faces of the mesh use each segment: 1 at a border, 2 inside a closed shell."""
        return self._data.segment_uses

    # What is known of each element and point

    @property
    def face(self) -> np.ndarray:
        """(m,) int32: id of the model face of each element, counted from 1."""
        return self._data.face

    @property
    def rule(self) -> np.ndarray:
        """(m,) uint16: which rule made each element: an index in `rule_names`."""
        return self._data.rule

    @property
    def rule_names(self) -> List[str]:
        """Titles of the rules, and behind them names of what makes elements where no rule does."""
        return self._report.rule_names

    @property
    def level(self) -> np.ndarray:
        """(m,) uint8: quality level of the rule at the element, 1 is best; 0: no rule made it."""
        return self._data.level

    @property
    def changed(self) -> np.ndarray:
        """(m,) bool: whether optimization gave the element other corners."""
        return self._data.changed

    @property
    def quality(self) -> np.ndarray:
        """(m,) float64: 1 is ideal, 0 degenerate, negative inverted (docs/formats.md, "Quality"). Computed once."""
        return self._data.quality

    @property
    def scores(self) -> np.ndarray:
        """(m,) float32: badness by the metric of the rule set, 0 is ideal, NaN where it has no value. Computed once."""
        return self._data.scores

    @property
    def wanted_sizes(self) -> np.ndarray:
        """(n,) float64: wanted edge length at each point; may be empty."""
        return self._data.wanted_sizes

    # Parts of the model

    @property
    def groups(self) -> List[Group]:
        """The groups of the model: parts, solids, layers, colours, interfaces, boundaries."""
        return [Group(self, group) for group in [*self._report.groups, *self._report.boundaries]]

    def group(self, name: str, kind: Optional[str] = None) -> Group:
        """The first group of this name or label, of any kind or of this one: "1" or "solid 1".

        Raises:
            KeyError: there is none; the text names those that there are.
        """
        for group in self.groups:
            if name in (group.name, group.label) and kind in (None, group.kind):
                return group
        names = ", ".join(sorted({repr(group.name) for group in self.groups})) or "none at all"
        raise KeyError(f"there is no group {name!r}; the mesh has {names}")

    # Reports

    @property
    def name(self) -> str:
        """Of the model, for people."""
        return self._report.name

    @property
    def status(self) -> str:
        """"complete", "partial" (some faces failed), "failed" (there is no mesh) or "cancelled"; of the faces alone."""
        return self._data.status

    @property
    def complete(self) -> bool:
        """Whether nothing is missing that was asked for: `problems` is empty."""
        return not self.problems

    @property
    def problems(self) -> List[str]:
        """What the mesh lacks, one text each: faces that failed, findings of the last checks, triangles in a mesh that
        should have quadrilaterals only, elements without a rule with strict_rules."""
        if self._problems is None:
            self._problems = self._found_problems()
        return list(self._problems)

    def _found_problems(self) -> List[str]:
        problems = []
        for face in self.faces:
            if face.status in ("failed", "cancelled"):
                name = f' "{face.name}"' if face.name else ""
                reason = f": {face.reason}" if face.reason else ""
                problems.append(f"face {face.id}{name} ({face.surface}) {face.status}{reason}")
        problems += self._lacks()
        if not problems and self.status != "complete":
            problems.append("there is no mesh" if self.status == "failed" else f"the run is {self.status}")
        return problems

    def _lacks(self) -> List[str]:
        """Problems besides faces that failed."""
        lacks = list(self.findings)
        if self._only_quads:
            lacks += [f"face {face.id} keeps {face.triangles} triangle{'s' * (face.triangles > 1)}, one of them at "
                      f"{_text(face.first_triangle)}; its boundary has {len(face.odd_loops)} odd loops"
                      for face in self.faces if face.triangles]
        if self._strict and sum(sum(face.without_rule.values()) for face in self.faces):
            lacks.append("elements were made without a rule, which strict_rules does not accept")
        return lacks

    @property
    def faces(self) -> List[Any]:
        """How the meshing of each face went, by id: `id`, `name`, `surface`, `chart`, `status` ("complete", "failed",
        "cancelled", "skipped"), `elements`, `seconds`, `area`, `reason`, `cause` ("model": no sizes help; "size": it is
        far too large; "": not known), `attempts`, `stuck` (fronts: `start`, `end`, `uv`, `level`, `refusals`), `acts`,
        `without_rule`, `layers`, `layer_elements`, `odd_loops`, `triangles`, `deviation`, `congruent_to` (id or 0)."""
        return self._report.faces

    @property
    def failures(self) -> List[Any]:
        """The faces that failed."""
        return [face for face in self.faces if face.status == "failed"]

    @property
    def findings(self) -> List[str]:
        """What the mesh lacks besides failed faces, such as faces of the file that could not be read."""
        return self._report.findings

    @property
    def notes(self) -> List[str]:
        """Repairs that were made while reading, and oddities of the model."""
        return self._report.notes

    @property
    def unit(self) -> str:
        """The unit of all lengths, "mm"; empty if the model does not say it."""
        return self._report.unit

    @property
    def healing(self) -> Any:
        """What healing changed: `tolerance`, `changes`, `undone`; None if it was not asked for."""
        return self._report.healing

    @property
    def imprinting(self) -> Any:
        """How parts were made to share faces: `tolerance`, `parts`, `interfaces`, `changes`, `undone`; or None."""
        return self._report.imprinting

    @property
    def merging(self) -> Any:
        """Which faces were meshed together: `angle`, `narrow`, `groups`, `vertices`, `chains`, `kept`; or None."""
        return self._report.merging

    @property
    def deviation(self) -> Any:
        """With `chord`: the `largest` distance found from the model, its `place`, `face` and `edge`; else None."""
        return self._report.deviation

    @property
    def periodic(self) -> List[Any]:
        """Pairs of periodic faces: `first`, `second`, `transform` (4, 4), `vertices` (n, 2): a point of the second face
        and the one of the first of which it is the image."""
        return self._report.periodic

    @property
    def measures(self) -> Any:
        """Statistics: `min`, `p1`, `mean` of the quality, `worst_face`, `worst_place`, `min_angle`, `max_angle` in
        degrees, `free_edges`, `edge_ratio` (lengths divided by wanted sizes)."""
        return self._data.measures

    @property
    def fingerprint(self) -> str:
        """16 hexadecimal digits that change when a single bit of the points or elements changes."""
        return self._data.fingerprint

    # Points of the model

    def snap(self, points: Any, faces: Any = None, *, threads: int = 0) -> Snapped:
        """The nearest points of the model, for those who refine or curve the mesh.

        Args:
            points: (n, 3) positions; (n, 2) in planar domains.
            faces: ids of the faces on which to search: (n,), or one for all; None: on all faces, which takes longer. For
                the middle of a side, take the `face` of its element. Surfaces of triangles are searched as a whole.
            threads: 0: all cores.

        Raises:
            InputError: a face does not exist, or a coordinate is not finite.
        """
        places = np.asarray(points, dtype=float)
        ids: List[int] = []
        if faces is not None:
            ids = [int(i) for i in np.broadcast_to(np.asarray(faces), (len(places),))]
        return Snapped(*self._data.snap(places, ids, threads))

    def evaluate(self, face: int, uv: Any) -> Snapped:
        """The points of a face with given parameters: positions and normals.

        Args:
            face: its id.
            uv: (n, 2) parameters, those of OpenCASCADE for CAD models, x and y for planar domains.

        Raises:
            InputError: there is no such face, a parameter is outside its range, or the surface has none (triangles).
        """
        return Snapped(*self._data.evaluate(int(face), np.asarray(uv, dtype=float).reshape(-1, 2)))

    # Files, parts and other packages

    def parts(self, count: int, *, edges: bool = False) -> List[Part]:
        """Divides the mesh into parts of about the same number of elements, with short borders, by METIS; in the same
        way each time. With mpi4py, `comm.scatter(mesh.parts(comm.size) if comm.rank == 0 else None)` sends them.

        Args:
            edges: line elements along all edges of the model, not only along those with boundary names.

        Raises:
            InputError: the count is below 1, or AF2 was built without METIS.
        """
        return divided(self._report, count, edges)

    def write(self, path: Union[str, "os.PathLike[str]"], *, edges: bool = False, groups: Sequence[str] = (),
              compress: bool = False, scale: Optional[float] = None, unit: Optional[str] = None) -> None:
        """Writes a file, completely or not at all. The extension selects the format, as for `af2 mesh -o`.

        Args:
            path: the file; one that exists is replaced.
            edges: also line elements along all edges of the model, in formats that have them.
            groups: each face is in one group only, of the first of these kinds in which it has one: "faces", "parts",
                "solids", "layers", "colors", "interfaces".
            compress: compress the arrays of VTU files.
            scale: multiplies all coordinates.
            unit: "mm", "cm", "m", "um", "inch", "in" or "ft", for models that say their unit.

        Raises:
            InputError: the format is unknown, cannot hold the mesh, or the file cannot be written.
        """
        self._data.write(os.fspath(path), bool(edges), [groups] if isinstance(groups, str) else list(groups),
                         bool(compress), _arguments.output_factor(scale, unit, self.unit))

    def write_report(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the report in JSON that docs/formats.md explains, except `stuck`, `statistics` and `contacts`."""
        self._data.write_report(os.fspath(path), "; ".join(self._lacks()))

    def html(self) -> str:
        """The page that shows the mesh in a browser, as `af2 mesh -o mesh.html` writes it."""
        with tempfile.TemporaryDirectory(prefix="af2-") as folder:
            path = os.path.join(folder, "mesh.html")
            self.write(path)
            with open(path, encoding="utf-8") as file:
                return file.read()

    def _repr_html_(self) -> str:
        """For notebooks: the page in a frame."""
        if not len(self.elements):
            return html.escape(repr(self))
        page = html.escape(self.html(), quote=True)
        return f'<iframe srcdoc="{page}" style="width: 100%; height: 600px; border: 0" title="Mesh"></iframe>'

    def to_meshio(self) -> Any:
        """A `meshio.Mesh` with blocks of triangles and quadrilaterals (of order 2: triangle6, quad8), and `face`, `rule`,
        `level` and `quality` as cell data. Groups are cell sets. Points are not copied.

        Raises:
            ImportError: meshio is not installed.
        """
        return _other_packages.meshio_of(self)

    def to_pyvista(self) -> Any:
        """A `pyvista.UnstructuredGrid` with `face`, `rule`, `level` and `quality` as cell data.

        Raises:
            ImportError: PyVista is not installed.
        """
        return _other_packages.pyvista_of(self)

    def __repr__(self) -> str:
        quads = self._data.quads
        parts = [f"{len(self.points)} points", f"{len(self.elements) - quads} triangles"]
        if quads:
            parts.append(f"{quads} quads")
        return f"<af2.Mesh '{self.name}': {', '.join(parts)}, {'complete' if self.complete else self.status}>"


def _text(place: Any) -> str:
    return "(" + ", ".join(f"{x:.4g}" for x in place) + ")"
