"""af2.mesh: from a model and what is wanted to a mesh."""

from __future__ import annotations

import json
import numbers
import os
import tempfile
from dataclasses import dataclass
from typing import Any, Callable, Dict, Iterable, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _af2
from ._errors import MeshError
from ._mesh import Mesh
from ._models import ModelLike, read
from ._rules import RulesLike, load_rules

Key = Union[int, str, Tuple[Union[int, str], ...]]
_UNLIMITED = 1e300
_DEPTHS = {"fast": 0, "good": 2, "best": 3}


@dataclass(frozen=True)
class Layers:
    """Layers of quadrilaterals along edges, for boundary layers of flows.

    Attributes:
        first: height of the layer at the edge, in model units.
        growth: ratio of the heights of successive layers.
        count: number of layers, from 1 to 1000.
        edges: edges by id, or by the name of a boundary, or of a face or group for the edges around it. None: all
            edges of `faces`.
        faces: faces that get the layers, by id or name. None: all that have such an edge.
    """

    first: float
    growth: float = 1.2
    count: int = 5
    edges: Union[int, str, Sequence[Union[int, str]]] = ()
    faces: Union[int, str, Sequence[Union[int, str]]] = ()


def mesh(model: ModelLike, size: Optional[float] = None, *, rules: RulesLike = None, check_rules: bool = True,
         curvature: Optional[float] = None, min_size: Optional[float] = None, max_size: Optional[float] = None,
         grading: Optional[float] = None, proximity: Optional[float] = None,
         sizes: Union[Callable[[np.ndarray], Any], Mapping[str, Any], str, "os.PathLike[str]", None] = None,
         face_sizes: Optional[Mapping[Key, float]] = None, edge_sizes: Optional[Mapping[Key, float]] = None,
         chord: Union[float, str, None] = None, face_chords: Optional[Mapping[Key, Union[float, str]]] = None,
         fewest: bool = False, faces: Union[Key, Iterable[Union[int, str]], None] = None, elements: str = "any",
         quality: Optional[str] = None, order: int = 1, chart: str = "auto",
         layers: Union[Layers, Sequence[Layers], None] = None, boundary: Optional[Mapping[int, Any]] = None,
         points: Any = None, curves: Optional[Sequence[Any]] = None, keep_boundary: bool = False,
         feature_angle: Optional[float] = None, heal: Union[bool, float] = False,
         imprint: Union[bool, float] = False, glue: Union[bool, float] = False, overlap: Optional[str] = None,
         periodic: Union[str, Sequence[Any], None] = None, merge: Union[bool, float] = False,
         merge_narrow: Optional[float] = None, merge_keep: Union[Key, Iterable[Union[int, str]], None] = None,
         optimize: bool = True, strict_rules: bool = False, threads: int = 0, max_memory: Optional[int] = None,
         progress: Optional[Callable[[Any], Any]] = None, trace: Optional[Callable[[Any], Any]] = None, allow_incomplete: bool = False,
         name: Optional[str] = None) -> Mesh:
    """Meshes a model. The mesh is the one that `af2 mesh` makes for the same request, to the last bit.

    The GIL is released while the mesher runs, so that several Python threads can mesh at once. Ctrl-C stops it.

    Args:
        model: what `af2.read` takes: a path, bytes, arrays, a CAD shape, an `af2.Model`.
        size: wanted edge length, in model units. May be left out with `fewest`.
        rules: an `af2.Rules`, a path, a name such as "quad/paving", or a text. By default "tri/even.af2", or
            "quad/classic.af2" with elements="quad".
        check_rules: see `Rules.from_text`.
        curvature: number of elements around a full turn of a curved face or edge.
        min_size, max_size: bounds of all sizes.
        grading: largest growth of the size per unit of length; 0.3 by default.
        proximity: number of elements across strips of faces, walls and gaps.
        sizes: further limits of the size:

            * a function that takes an array of points, shape (n, 3), and returns n sizes, or one for all. It must be
              pure: the same points get the same sizes. It may be called from other threads (with the GIL), with many
              points along edges and over faces and with single points at the front; infinity means no limit;
            * a dictionary with "points", "boxes", "fields", "parts", "chords" as in files for `--sizes`
              (docs/formats.md), or the path of such a file.
        face_sizes: sizes of some faces instead of `size`: `{3: 0.1, (7, 8): 0.2, "inlet*": 0.05}`, by ids and names of
            faces and groups. A name may have `*` and `?`; ids take precedence, and of several matching names the last.
        edge_sizes: sizes along some edges, by ids and by names of boundaries, or of faces and groups for the edges
            around them.
        chord: largest distance between mesh and model: a length, or a share of the size such as "5%".
        face_chords: other such bounds on some faces, by ids and names.
        fewest: as few triangles as `chord` allows, of any size and shape.
        faces: mesh only these faces, by ids and names.
        elements: "any", or "quad": quadrilaterals only. A triangle that remains makes the mesh incomplete.
        quality: "fast", "good" or "best": how long to look for better quadrilaterals.
        order: 1, or 2: extra vertices at the middles of sides, on the surface (`Mesh.midsides`).
        chart: kind of charts in which curved faces are meshed, such as "mean-normal" (docs/charts.md).
        layers: one or more `af2.Layers`.
        boundary: vertices along edges that are divided already: by edge id, the (n, 3) vertices between the ends of
            the edge in order. The mesh has exactly these on these edges.
        points: (n, 3) positions inside faces that become vertices; (n, 2) in planar domains.
        curves: polylines inside faces, each (n, 3), that become edges.
        keep_boundary: planar domains: do not divide the segments.
        feature_angle: surfaces of triangles: edges at which the surface turns by more than this, in degrees, are kept;
            40 by default.
        heal: repair a CAD model first; a number is the tolerance. Changes: `Mesh.healing`.
        imprint: make parts that touch share their faces; a number is the tolerance. Result: `Mesh.imprinting`.
        glue: the same for equal faces only.
        overlap: with `imprint`: "first", "last" or "cut", what becomes of the common volume of two solids; without it
            they are refused.
        periodic: "x", "y" or "z", or pairs of faces such as [(3, 5), ("inlet", "outlet")], or a list of these: the
            mesh of the second face is the image of that of the first. Result: `Mesh.periodic`.
        merge: mesh across edges at which faces meet by no more than 10 degrees, or by this angle. `Mesh.merging`.
        merge_narrow: with `merge`: share of the size below which faces and edges do not count; 0.2 by default.
        merge_keep: with `merge`: ids of edges that stay, and names of faces and groups whose edges stay.
        optimize: swap and smooth after the front has closed; False keeps what the front made.
        strict_rules: only rules make elements: a face fails at the first edge that no rule takes.
        threads: number of threads, 0: all cores. The mesh does not depend on it.
        max_memory: bytes for the mesh; sizes that need more are refused before meshing begins.
        progress: called with an `af2.Progress` now and then, from other threads, one call at a time. An exception that
            it raises stops the mesher and is raised by `mesh`.
        trace: called with an `af2.Step` for every step of every front: `face`, `start`, `end` (of the base edge), `level`,
            `applied`, `rule` (an index in `Mesh.rule_names`, or None), `score`, `elements`, `front_edges`, `refusals`
            (pairs of rule and reason). From other threads, unless threads=1; slow.
        allow_incomplete: return the mesh even if it is not complete. See `Mesh.complete`.
        name: of the model in files and pages; by default that of the file.

    Returns:
        The mesh.

    Raises:
        InputError: the model or an argument cannot be used; the text names it.
        RuleError: the rules have errors.
        MeshError: the mesh is not complete: faces failed, or it lacks something that was asked for. The error has the
            mesh so far. Not raised with `allow_incomplete`.
        KeyboardInterrupt: Ctrl-C was pressed; the mesher has stopped.
        MemoryError: there is not enough memory.
    """
    source = read(model)
    _check_words(elements, quality, order, threads)
    loaded = load_rules(rules or ("quad/classic.af2" if elements == "quad" else "tri/even.af2"), check=check_rules)
    asked: Dict[str, Any] = {"order": order, "threads": int(threads), "optimize": bool(optimize), "chart": chart,
                             "strict_rules": bool(strict_rules), "fewest": bool(fewest)}
    _take_sizes(asked, size, sizes, curvature=curvature, min_size=min_size, max_size=max_size, grading=grading,
                proximity=proximity)
    _take_chords(asked, chord, face_chords, fewest)
    _take_parts(asked, face_sizes, edge_sizes)
    if faces is not None:
        asked["faces"], asked["face_names"] = _ids_and_names(faces, "faces")
    _take_quads(asked, elements, quality, optimize, strict_rules, loaded)
    _take_layers(asked, layers)
    if boundary is not None:
        asked["boundary"] = {int(edge): np.asarray(places, dtype=float) for edge, places in boundary.items()}
    _take_kind(asked, source.kind, points, curves, keep_boundary, feature_angle, chart)
    _take_changes(asked, source.kind, heal, imprint, glue, overlap, periodic)
    _take_merge(asked, source.kind, merge, merge_narrow, merge_keep)
    _check_combinations(asked)
    if max_memory is not None:
        asked["max_memory"] = _positive(max_memory, "max_memory")
    if progress is not None:
        asked["progress"] = progress
    if trace is not None:
        asked["trace"] = trace
    with _SizeFile(sizes) as file:
        if file:
            asked["size_file"] = file
        data = _af2.mesh(source._handle, loaded._file, asked, name or source.name)
    made = Mesh(data, strict=strict_rules, only_quads=elements == "quad")
    if not made.complete and not allow_incomplete:
        raise MeshError(made)
    return made


def _positive(value: Any, argument: str) -> float:
    if isinstance(value, bool) or not isinstance(value, (numbers.Real, np.floating, np.integer)):
        raise _af2.InputError(f"{argument}: expected a number, not {value!r}")
    number = float(value)
    if not number > 0 or not np.isfinite(number):
        raise _af2.InputError(f"{argument}={value!r}: must be a finite number greater than 0")
    return number


def _check_words(elements: str, quality: Optional[str], order: int, threads: int) -> None:
    if elements not in ("any", "quad"):
        raise _af2.InputError(f"elements={elements!r}: choose 'any' or 'quad'")
    if quality is not None and quality not in _DEPTHS:
        raise _af2.InputError(f"quality={quality!r}: choose 'fast', 'good' or 'best'")
    if order not in (1, 2):
        raise _af2.InputError(f"order={order!r}: elements can have order 1 or 2")
    if not isinstance(threads, (int, np.integer)) or not 0 <= threads <= 4096:
        raise _af2.InputError(f"threads={threads!r}: give a number from 1 to 4096, or 0 for all cores")


def _take_sizes(asked: Dict[str, Any], size: Optional[float], sizes: Any, **limits: Optional[float]) -> None:
    if size is not None:
        asked["size"] = _positive(size, "size")
    elif asked["fewest"]:
        asked["size"] = _UNLIMITED  # only the model and the distance limit the elements
    else:
        raise _af2.InputError("size: give the wanted edge length, in model units")
    for argument, value in limits.items():
        if value is not None:
            asked[argument] = _positive(value, argument)
    if asked.get("min_size", 0) > asked.get("max_size", np.inf):
        raise _af2.InputError(f"min_size={asked['min_size']} is above max_size={asked['max_size']}")
    if asked.get("curvature", 3) < 3:
        raise _af2.InputError(f"curvature={asked['curvature']}: a turn needs at least 3 elements")
    if asked.get("grading", 0) > 10:
        raise _af2.InputError(f"grading={asked['grading']}: the growth must be at most 10 per unit of length")
    if callable(sizes):
        asked["size_function"] = sizes
    elif sizes is not None and not isinstance(sizes, (Mapping, str, os.PathLike)):
        raise _af2.InputError(f"sizes: expected a function of points, a dictionary or a path, not {sizes!r}")


class _SizeFile:
    """The path of the file of sizes; a dictionary becomes one, so that both are checked alike."""

    def __init__(self, sizes: Any):
        self._sizes = sizes
        self._folder: Optional[tempfile.TemporaryDirectory] = None

    def __enter__(self) -> Optional[str]:
        if isinstance(self._sizes, Mapping):
            self._folder = tempfile.TemporaryDirectory(prefix="af2-")
            path = os.path.join(self._folder.name, "sizes.json")
            with open(path, "w", encoding="utf-8") as file:
                json.dump(self._sizes, file, default=_plain)
            return path
        return os.fspath(self._sizes) if isinstance(self._sizes, (str, os.PathLike)) else None

    def __exit__(self, kind: Any, error: Any, trace: Any) -> None:
        if self._folder is None:
            return
        folder, self._folder = self._folder, None
        path = os.path.join(folder.name, "sizes.json")
        folder.cleanup()
        if isinstance(error, _af2.InputError) and path in str(error):
            raise _af2.InputError(str(error).replace(path, "sizes")) from None


def _plain(value: Any) -> Any:
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    raise _af2.InputError(f"sizes: {value!r} cannot be used")


def _chord(value: Union[float, str], argument: str) -> Tuple[float, bool]:
    if isinstance(value, str) and value.endswith("%"):
        try:
            return 0.01 * _positive(float(value[:-1]), argument), True
        except ValueError:
            raise _af2.InputError(f"{argument}={value!r}: expected a length or a share such as '5%'") from None
    return _positive(value, argument), False


def _take_chords(asked: Dict[str, Any], chord: Any, face_chords: Any, fewest: bool) -> None:
    if chord is not None:
        asked["chord"] = _chord(chord, "chord")
    elif fewest:
        raise _af2.InputError("fewest: give chord, the largest distance from the model")
    if fewest and asked["size"] == _UNLIMITED and asked["chord"][1]:
        raise _af2.InputError(f"chord={chord!r}: a share of the size needs a size")
    by_id, by_name = _by_part(face_chords, "face_chords", _chord)
    asked["face_chords"], asked["part_chords"] = by_id, dict(by_name)


def _take_parts(asked: Dict[str, Any], face_sizes: Any, edge_sizes: Any) -> None:
    asked["face_sizes"], asked["part_sizes"] = _by_part(face_sizes, "face_sizes", _positive)
    asked["edge_sizes"], asked["edge_names"] = _by_part(edge_sizes, "edge_sizes", _positive)


def _by_part(values: Optional[Mapping[Key, Any]], argument: str,
             convert: Callable[[Any, str], Any]) -> Tuple[Dict[int, Any], List[Tuple[str, Any]]]:
    by_id: Dict[int, Any] = {}
    by_name: List[Tuple[str, Any]] = []
    if values is not None and not isinstance(values, Mapping):
        raise _af2.InputError(f"{argument}: expected a dictionary such as {{3: 0.1, 'inlet': 0.2}}, not {values!r}")
    for key, value in (values or {}).items():
        ids, names = _ids_and_names(key, argument)
        converted = convert(value, f"{argument}[{key!r}]")
        by_id.update(dict.fromkeys(ids, converted))
        by_name.extend((part, converted) for part in names)
    return by_id, by_name


def _ids_and_names(parts: Any, argument: str) -> Tuple[List[int], List[str]]:
    if isinstance(parts, (str, numbers.Integral)):
        parts = [parts]
    ids: List[int] = []
    names: List[str] = []
    try:
        for part in parts:
            if isinstance(part, str):
                names.append(part)
            elif isinstance(part, numbers.Integral) and not isinstance(part, bool):
                ids.append(int(part))
            else:
                raise TypeError
    except TypeError:
        raise _af2.InputError(f"{argument}: expected ids and names, not {parts!r}") from None
    return ids, names


def _take_quads(asked: Dict[str, Any], elements: str, quality: Optional[str], optimize: bool, strict: bool,
                rules: Any) -> None:
    asked["quads"] = elements == "quad"
    if quality is not None:
        asked["depth"] = _DEPTHS[quality]
    if elements != "quad":
        return
    if not optimize or strict:
        raise _af2.InputError("elements='quad' joins triangles after the fronts have closed; leave out "
                              + ("strict_rules" if strict else "optimize=False"))
    if not rules.makes_quads:
        raise _af2.InputError(f"elements='quad': the rules {rules.name!r} make no quadrilaterals; leave out rules, or use "
                              "'quad/classic'")


def _take_layers(asked: Dict[str, Any], layers: Any) -> None:
    requests = []
    for one in [layers] if isinstance(layers, Layers) else layers or []:
        if not isinstance(one, Layers):
            raise _af2.InputError(f"layers: expected af2.Layers, not {one!r}")
        edges, edge_names = _ids_and_names(one.edges, "layers")
        faces, face_names = _ids_and_names(one.faces, "layers")
        if not 1 <= one.count <= 1000:
            raise _af2.InputError(f"layers: count={one.count!r}: give a whole number from 1 to 1000")
        requests.append({"edges": edges, "edge_names": edge_names, "faces": faces, "face_names": face_names,
                         "first": _positive(one.first, "layers: first"), "growth": _positive(one.growth, "layers: growth"),
                         "count": int(one.count)})
    if requests:
        asked["layers"] = requests


def _take_kind(asked: Dict[str, Any], kind: str, points: Any, curves: Any, keep_boundary: bool,
               feature_angle: Optional[float], chart: str) -> None:
    if keep_boundary and kind != "planar":
        raise _af2.InputError("keep_boundary is for planar domains; for other models use boundary")
    asked["keep_boundary"] = bool(keep_boundary)
    if feature_angle is not None:
        if kind != "triangles":
            raise _af2.InputError("feature_angle is for surfaces of triangles")
        asked["feature_angle"] = _positive(feature_angle, "feature_angle")
    if chart != "auto" and kind == "planar":
        raise _af2.InputError("chart is for curved faces; a planar domain is its own chart")
    if (points is not None or curves is not None) and kind not in ("cad", "planar"):
        raise _af2.InputError("points and curves are for CAD models and planar domains")
    if points is not None:
        asked["points"] = np.asarray(points, dtype=float)
    if curves is not None:
        asked["curves"] = [np.asarray(curve, dtype=float) for curve in curves]


def _switch(asked: Dict[str, Any], kind: str, argument: str, value: Union[bool, float], tolerance: str) -> bool:
    """An argument that is False, True, or a tolerance."""
    if value is False or value is None:
        return False
    if kind != "cad":
        raise _af2.InputError(f"{argument} is for CAD models")
    asked[argument] = True
    if value is not True:
        asked[tolerance] = _positive(value, argument)
    return True


def _take_changes(asked: Dict[str, Any], kind: str, heal: Any, imprint: Any, glue: Any, overlap: Optional[str],
                  periodic: Any) -> None:
    _switch(asked, kind, "heal", heal, "heal_tolerance")
    is_imprinted = _switch(asked, kind, "imprint", imprint, "imprint_tolerance")
    if _switch(asked, kind, "glue", glue, "imprint_tolerance") and is_imprinted:
        raise _af2.InputError("imprint and glue exclude each other; imprint does all that glue does")
    if overlap is not None:
        if overlap not in ("first", "last", "cut"):
            raise _af2.InputError(f"overlap={overlap!r}: choose 'first', 'last' or 'cut'")
        if not is_imprinted:
            raise _af2.InputError("overlap needs imprint")
        asked["overlap"] = overlap
    if periodic is None:
        return
    if kind != "cad":
        raise _af2.InputError("periodic is for CAD models")
    directions, pairs = [], []
    for one in [periodic] if isinstance(periodic, str) else periodic:
        if one in ("x", "y", "z"):
            directions.append(one)
        elif isinstance(one, (tuple, list)) and len(one) == 2:
            pairs.append(tuple(one))
        else:
            raise _af2.InputError(f"periodic: expected 'x', 'y', 'z' or pairs of faces, not {one!r}")
    asked["periodic_directions"], asked["periodic_pairs"] = directions, pairs


def _take_merge(asked: Dict[str, Any], kind: str, merge: Any, narrow: Optional[float], keep: Any) -> None:
    request: Dict[str, Any] = {}
    if not _switch(request, kind, "merge", merge, "angle"):
        if narrow is not None or keep is not None:
            raise _af2.InputError(f"{'merge_keep' if narrow is None else 'merge_narrow'} needs merge")
        return
    request.pop("merge")
    if narrow is not None:
        request["narrow"] = float(narrow)
    if keep is not None:
        ids, request["keep_around"] = _ids_and_names(keep, "merge_keep")
        request["keep"] = set(ids)
    asked["merge"] = request


def _check_combinations(asked: Dict[str, Any]) -> None:
    is_periodic = bool(asked.get("periodic_directions") or asked.get("periodic_pairs"))
    has_faces = bool(asked.get("faces") or asked.get("face_names"))
    if is_periodic and (asked["order"] != 1 or asked["fewest"] or has_faces):
        raise _af2.InputError("periodic cannot be combined with order=2, fewest and faces")
    if "merge" in asked and (is_periodic or asked["fewest"] or "layers" in asked):
        raise _af2.InputError("merge cannot be combined with periodic, fewest and layers")
    if asked["fewest"] and (asked["order"] != 1 or asked["quads"]):
        raise _af2.InputError("fewest is for triangles of order 1")
    if asked["fewest"] and "layers" in asked:
        raise _af2.InputError("fewest cannot be combined with layers")
