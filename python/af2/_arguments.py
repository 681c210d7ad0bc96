"""From the arguments of af2.mesh to the dictionary that the extension module takes. Each fault names its argument."""

from __future__ import annotations

import json
import numbers
import os
import tempfile
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _af2

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


def positive(value: Any, argument: str) -> float:
    if callable(value):
        raise _af2.InputError(f"{argument}: expected a number; a function of the position is given as sizes=")
    if isinstance(value, bool) or not isinstance(value, (numbers.Real, np.floating, np.integer)):
        raise _af2.InputError(f"{argument}: expected a number, not {value!r}")
    number = float(value)
    if not number > 0 or not np.isfinite(number):
        raise _af2.InputError(f"{argument}={value!r}: must be a finite number greater than 0")
    return number


def check_words(elements: str, quality: Optional[str], order: int, threads: int) -> None:
    if elements not in ("any", "quad"):
        raise _af2.InputError(f"elements={elements!r}: choose 'any' or 'quad'")
    if quality is not None and quality not in _DEPTHS:
        raise _af2.InputError(f"quality={quality!r}: choose 'fast', 'good' or 'best'")
    if order not in (1, 2):
        raise _af2.InputError(f"order={order!r}: elements can have order 1 or 2")
    if not isinstance(threads, (int, np.integer)) or not 0 <= threads <= 4096:
        raise _af2.InputError(f"threads={threads!r}: give a number from 1 to 4096, or 0 for all cores")


def take_sizes(asked: Dict[str, Any], size: Optional[float], sizes: Tuple[Any, Any], **limits: Optional[float]) -> None:
    if size is not None:
        asked["size"] = positive(size, "size")
    elif asked["fewest"]:
        asked["size"] = _UNLIMITED  # only the model and the distance limit the elements
    else:
        raise _af2.InputError("size: give the wanted edge length, in model units")
    for argument, value in limits.items():
        if value is not None:
            asked[argument] = positive(value, argument)
    if asked.get("min_size", 0) > asked.get("max_size", np.inf):
        raise _af2.InputError(f"min_size={asked['min_size']} is above max_size={asked['max_size']}")
    if asked.get("curvature", 3) < 3:
        raise _af2.InputError(f"curvature={asked['curvature']}: a turn needs at least 3 elements")
    if asked.get("grading", 0) > 10:
        raise _af2.InputError(f"grading={asked['grading']}: the growth must be at most 10 per unit of length")
    if sizes[0] is not None:
        asked["size_function"] = sizes[0]


def function_and_file(sizes: Any) -> Tuple[Any, Any]:
    """What was given as sizes: a function, and a dictionary or a path; None for what was not."""
    function = file = None
    for one in sizes if isinstance(sizes, (list, tuple)) else [sizes]:
        if callable(one) and function is None:
            function = one
        elif isinstance(one, (Mapping, str, os.PathLike)) and file is None:
            file = one
        elif one is not None:
            raise _af2.InputError("sizes: expected a function of points, a dictionary or a path, or a list of one function "
                                  f"and one of the others, not {sizes!r}")
    return function, file


def output_factor(scale: Optional[float], unit: Optional[str], unit_of_model: str) -> float:
    """By which the coordinates of a file are multiplied."""
    if scale is not None and unit is not None:
        raise _af2.InputError("scale and unit exclude each other")
    if scale is not None:
        return positive(scale, "scale")
    if unit is None:
        return 1.0
    units = _af2.length_units()
    if unit not in units:
        raise _af2.InputError(f"unit={unit!r}: choose one of {', '.join(units)}")
    if unit_of_model != "mm":
        raise _af2.InputError(f"unit={unit!r}: the model does not say its unit; use scale")
    return units[unit]


class SizeFile:
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
            return 0.01 * positive(float(value[:-1]), argument), True
        except ValueError:
            raise _af2.InputError(f"{argument}={value!r}: expected a length or a share such as '5%'") from None
    return positive(value, argument), False


def take_chords(asked: Dict[str, Any], chord: Any, face_chords: Any, fewest: bool) -> None:
    if chord is not None:
        asked["chord"] = _chord(chord, "chord")
    elif fewest:
        raise _af2.InputError("fewest: give chord, the largest distance from the model")
    if fewest and asked["size"] == _UNLIMITED and asked["chord"][1]:
        raise _af2.InputError(f"chord={chord!r}: a share of the size needs a size")
    by_id, by_name = _by_part(face_chords, "face_chords", _chord)
    asked["face_chords"], asked["part_chords"] = by_id, dict(by_name)


def take_parts(asked: Dict[str, Any], face_sizes: Any, edge_sizes: Any) -> None:
    asked["face_sizes"], asked["part_sizes"] = _by_part(face_sizes, "face_sizes", positive)
    asked["edge_sizes"], asked["edge_names"] = _by_part(edge_sizes, "edge_sizes", positive)


def _by_part(values: Optional[Mapping[Key, Any]], argument: str,
             convert: Callable[[Any, str], Any]) -> Tuple[Dict[int, Any], List[Tuple[str, Any]]]:
    by_id: Dict[int, Any] = {}
    by_name: List[Tuple[str, Any]] = []
    if values is not None and not isinstance(values, Mapping):
        raise _af2.InputError(f"{argument}: expected a dictionary such as {{3: 0.1, 'inlet': 0.2}}, not {values!r}")
    for key, value in (values or {}).items():
        ids, names = ids_and_names(key, argument)
        converted = convert(value, f"{argument}[{key!r}]")
        by_id.update(dict.fromkeys(ids, converted))
        by_name.extend((part, converted) for part in names)
    return by_id, by_name


def ids_and_names(parts: Any, argument: str) -> Tuple[List[int], List[str]]:
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


def take_quads(asked: Dict[str, Any], elements: str, quality: Optional[str], optimize: bool, strict: bool,
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


def take_layers(asked: Dict[str, Any], layers: Any) -> None:
    requests = []
    for one in [layers] if isinstance(layers, Layers) else layers or []:
        if not isinstance(one, Layers):
            raise _af2.InputError(f"layers: expected af2.Layers, not {one!r}")
        edges, edge_names = ids_and_names(one.edges, "layers")
        faces, face_names = ids_and_names(one.faces, "layers")
        if not 1 <= one.count <= 1000:
            raise _af2.InputError(f"layers: count={one.count!r}: give a whole number from 1 to 1000")
        requests.append({"edges": edges, "edge_names": edge_names, "faces": faces, "face_names": face_names,
                         "first": positive(one.first, "layers: first"), "growth": positive(one.growth, "layers: growth"),
                         "count": int(one.count)})
    if requests:
        asked["layers"] = requests


def take_kind(asked: Dict[str, Any], kind: str, points: Any, curves: Any, keep_boundary: bool,
               feature_angle: Optional[float], chart: str) -> None:
    if keep_boundary and kind != "planar":
        raise _af2.InputError("keep_boundary is for planar domains; for other models use boundary")
    asked["keep_boundary"] = bool(keep_boundary)
    if feature_angle is not None:
        if kind != "triangles":
            raise _af2.InputError("feature_angle is for surfaces of triangles")
        asked["feature_angle"] = positive(feature_angle, "feature_angle")
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
        asked[tolerance] = positive(value, argument)
    return True


def take_changes(asked: Dict[str, Any], kind: str, heal: Any, imprint: Any, glue: Any, overlap: Optional[str],
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


def take_merge(asked: Dict[str, Any], kind: str, merge: Any, narrow: Optional[float], keep: Any) -> None:
    request: Dict[str, Any] = {}
    if not _switch(request, kind, "merge", merge, "angle"):
        if narrow is not None or keep is not None:
            raise _af2.InputError(f"{'merge_keep' if narrow is None else 'merge_narrow'} needs merge")
        return
    request.pop("merge")
    if narrow is not None:
        request["narrow"] = float(narrow)
    if keep is not None:
        ids, request["keep_around"] = ids_and_names(keep, "merge_keep")
        request["keep"] = set(ids)
    asked["merge"] = request


def check_combinations(asked: Dict[str, Any]) -> None:
    is_periodic = bool(asked.get("periodic_directions") or asked.get("periodic_pairs"))
    has_faces = bool(asked.get("faces") or asked.get("face_names"))
    if is_periodic and (asked["fewest"] or has_faces):
        raise _af2.InputError("periodic cannot be combined with fewest and faces")
    if "merge" in asked and asked["fewest"]:
        raise _af2.InputError("merge cannot be combined with fewest")
    if asked["fewest"] and (asked["order"] != 1 or asked["quads"]):
        raise _af2.InputError("fewest is for triangles of order 1")
    if asked["fewest"] and "layers" in asked:
        raise _af2.InputError("fewest cannot be combined with layers")
