"""af2.mesh: from a model and what is wanted to a mesh."""

from __future__ import annotations

import os
from typing import Any, Callable, Dict, Iterable, Mapping, Optional, Sequence, Union

import numpy as np

from . import _af2, _arguments
from ._arguments import Key, Layers
from ._errors import MeshError
from ._mesh import Mesh
from ._models import ModelLike, read
from ._rules import RulesLike, load_rules


def mesh(model: ModelLike, size: Optional[float] = None, *, names: Optional[Mapping[str, Any]] = None,
         rules: RulesLike = None, check_rules: bool = True, curvature: Optional[float] = None,
         min_size: Optional[float] = None, max_size: Optional[float] = None, grading: Optional[float] = None,
         proximity: Optional[float] = None,
         sizes: Union[Callable[[np.ndarray], Any], Mapping[str, Any], str, "os.PathLike[str]", Sequence[Any], None] = None,
         size_fields: Union[str, "os.PathLike[str]", Sequence[Union[str, "os.PathLike[str]"]], None] = None,
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
         coarsen: bool = False,
         progress: Optional[Callable[[_af2.Progress], Any]] = None, trace: Optional[Callable[[_af2.Step], Any]] = None,
         allow_incomplete: bool = False, name: Optional[str] = None) -> Mesh:
    """Meshes a model. The mesh is the one that `af2 mesh` makes for the same request, to the last bit.

    The GIL is released while the mesher runs, so that several Python threads can mesh at once. Ctrl-C stops it.

    Args:
        model: what `af2.read` takes: a path, bytes, arrays, a CAD shape, an `af2.Model`.
        size: wanted edge length, in model units. May be left out with `fewest`.
        names: names for faces of a CAD model, by name an id or several: `{"inlet": 3, "walls": [1, 2]}`. They become
            groups in files, and other arguments can use them.
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
              (docs/formats.md), or the path of such a file;
            * a list of one function and one of these.
        size_fields: sizes at the vertices of other meshes: the path of an `.msh`, `.pos` or `.vtu` file, or
            "path:array" if it has several arrays; or a list of these.
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
        coarsen: larger sizes, rather than a refusal, where those that are asked for need too much memory; `mesh.notes`
            tells how much larger.
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
    source = read(model, names)
    _arguments.check_words(elements, quality, order, threads)
    loaded = load_rules(rules or ("quad/classic.af2" if elements == "quad" else "tri/even.af2"), check=check_rules)
    asked: Dict[str, Any] = {"order": order, "threads": int(threads), "optimize": bool(optimize), "chart": chart,
                             "strict_rules": bool(strict_rules), "fewest": bool(fewest), "coarsen": bool(coarsen)}
    limits = _arguments.function_and_file(sizes)
    _arguments.take_sizes(asked, size, limits, curvature=curvature, min_size=min_size, max_size=max_size, grading=grading,
                          proximity=proximity)
    _arguments.take_chords(asked, chord, face_chords, fewest)
    _arguments.take_parts(asked, face_sizes, edge_sizes)
    if faces is not None:
        asked["faces"], asked["face_names"] = _arguments.ids_and_names(faces, "faces")
    _arguments.take_quads(asked, elements, quality, optimize, strict_rules, loaded)
    _arguments.take_layers(asked, layers)
    if boundary is not None:
        asked["boundary"] = {int(edge): np.asarray(places, dtype=float) for edge, places in boundary.items()}
    _arguments.take_kind(asked, source.kind, points, curves, keep_boundary, feature_angle, chart)
    _arguments.take_changes(asked, source.kind, heal, imprint, glue, overlap, periodic)
    _arguments.take_merge(asked, source.kind, merge, merge_narrow, merge_keep)
    _arguments.check_combinations(asked)
    if size_fields is not None:
        fields = [size_fields] if isinstance(size_fields, (str, os.PathLike)) else size_fields
        asked["size_fields"] = [os.fspath(field) for field in fields]
    if max_memory is not None:
        asked["max_memory"] = _arguments.positive(max_memory, "max_memory")
    if progress is not None:
        asked["progress"] = progress
    if trace is not None:
        asked["trace"] = trace
    with _arguments.SizeFile(limits[1]) as file:
        if file:
            asked["size_file"] = file
        data = _af2.mesh(source._handle, loaded._file, asked, name or source.name)
    made = Mesh(data, strict=strict_rules, only_quads=elements == "quad")
    if not made.complete and not allow_incomplete:
        raise MeshError(made)
    return made
