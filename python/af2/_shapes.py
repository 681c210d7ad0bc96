"""Shapes of other packages, handed over as bytes of a BREP file.

Each of these packages brings an OpenCASCADE of its own, so that a shape in memory cannot be shared. A BREP file keeps
the faces and edges in their order. Nothing is imported here that the caller has not imported already.
"""

from __future__ import annotations

import io
import os
import sys
import tempfile
from typing import Any, Callable, List, Optional

from . import _af2


def brep_of(shape: Any) -> Optional[bytes]:
    """The shape as BREP (or STEP) bytes; None if it is of no known package."""
    for way in (_netgen, _freecad, _cadquery, _build123d, _ocp, _pythonocc):
        content = way(shape)
        if content is not None:
            return content
    return None


def _module_of(thing: Any) -> str:
    return (thing if isinstance(thing, type) else type(thing)).__module__ or ""


def _is_from(thing: Any, *packages: str) -> bool:
    """Whether the class, or one of those that it derives from, is of one of the packages."""
    return any((base.__module__ or "").split(".")[0] in packages for base in type(thing).__mro__)


def _through_file(write: Callable[[str], Any], what: str) -> bytes:
    with tempfile.TemporaryDirectory(prefix="af2-") as folder:
        path = os.path.join(folder, "shape.brep")
        done = write(path)
        if done is False or not os.path.exists(path) or os.path.getsize(path) == 0:
            raise _af2.InputError(f"{what} could not be written as a BREP file by its own package")
        with open(path, "rb") as file:
            return file.read()


def _through_stream_or_file(write: Callable[[Any], Any], what: str) -> bytes:
    """Older versions write only to files."""
    stream = io.BytesIO()
    try:
        if write(stream) is not False and stream.tell() > 0:
            return stream.getvalue()
    except TypeError:
        pass
    return _through_file(write, what)


def _netgen(shape: Any) -> Optional[bytes]:
    """Netgen: an OCCGeometry, which has the shape, or a shape (TopoDS_Shape, Solid, Face, ...)."""
    if hasattr(shape, "GenerateMesh") and hasattr(shape, "shape"):
        shape = shape.shape
    for method in ("WriteBrep", "WriteStep"):
        if hasattr(shape, method):
            return _through_file(getattr(shape, method), f"this {type(shape).__name__} of Netgen")
    return None


def _freecad(shape: Any) -> Optional[bytes]:
    """FreeCAD: an object of a document has a Shape. Shapes themselves are written as those of CadQuery."""
    inner = getattr(shape, "Shape", None)
    if not hasattr(inner, "exportBrep"):
        return None
    if getattr(inner, "isNull", bool)():
        raise _af2.InputError(f"the object '{getattr(shape, 'Label', '')}' of FreeCAD has no shape; recompute its document")
    return _cadquery(inner)


def _cadquery(shape: Any) -> Optional[bytes]:
    """CadQuery: a Shape has exportBrep, a Workplane has objects with it, an Assembly or Sketch is converted."""
    if hasattr(shape, "exportBrep"):
        return _through_stream_or_file(shape.exportBrep, f"this {type(shape).__name__}")
    if hasattr(shape, "toCompound"):  # Assembly
        return _cadquery(shape.toCompound())
    if callable(getattr(shape, "vals", None)) and hasattr(shape, "val"):  # Workplane
        return _cadquery(_one_of(shape.vals()))
    if hasattr(shape, "_faces") and hasattr(shape._faces, "exportBrep"):  # Sketch
        return _cadquery(shape._faces)
    return None


def _one_of(values: List[Any]) -> Any:
    """The only one of the objects of a workplane, or their compound."""
    shapes = [value for value in values if hasattr(value, "exportBrep")]
    if not shapes:
        raise _af2.InputError("the CadQuery workplane has no shape; build one, such as with .box(1, 1, 1)")
    if len(shapes) == 1:
        return shapes[0]
    compound = getattr(sys.modules[_module_of(shapes[0])], "Compound", None)
    if compound is None:
        raise _af2.InputError("the CadQuery workplane has several shapes; combine them, or give one of them")
    return compound.makeCompound(shapes)


def _build123d(shape: Any) -> Optional[bytes]:
    """build123d: a builder has a part or sketch; a Shape is exported by a function of the package."""
    if not _is_from(shape, "build123d"):
        return None
    for attribute in ("part", "sketch"):
        inner = getattr(shape, attribute, None)
        if inner is not None and not hasattr(shape, "wrapped"):
            shape = inner
            break
    if hasattr(shape, "export_brep"):  # before 0.6
        return _through_stream_or_file(shape.export_brep, f"this {type(shape).__name__}")
    export: Any = getattr(sys.modules.get("build123d"), "export_brep", None)
    if export is not None:
        return _through_file(lambda path: export(shape, path), f"this {type(shape).__name__}")
    return _ocp(getattr(shape, "wrapped", None))


def _ocp(shape: Any) -> Optional[bytes]:
    """A TopoDS_Shape of OCP, on which CadQuery and build123d stand; also what wraps one."""
    shape = getattr(shape, "wrapped", shape)
    if not _is_from(shape, "OCP"):
        return None
    from OCP.BRepTools import BRepTools  # loaded already, with the shape

    return _through_file(lambda path: BRepTools.Write_s(shape, path), "this TopoDS_Shape of OCP")


def _pythonocc(shape: Any) -> Optional[bytes]:
    """A TopoDS_Shape of pythonocc."""
    if not _is_from(shape, "OCC"):
        return None
    from OCC.Core import BRepTools  # loaded already, with the shape

    # The name of the function has changed with the versions.
    write: Any = (getattr(getattr(BRepTools, "breptools", None), "Write", None)
                  or getattr(BRepTools, "breptools_Write", None))
    if write is None:
        raise _af2.InputError("this version of pythonocc has no breptools.Write; write the shape to a file yourself")
    return _through_file(lambda path: write(shape, path), "this TopoDS_Shape of pythonocc")
