"""AF2: meshes of surfaces, made by an advancing front that rules steer.

    import af2
    mesh = af2.mesh("part.step", size=0.5)
    mesh.points      # (n, 3) float64
    mesh.triangles   # (m, 3) int32
    mesh.write("part.vtu")

Models are files, bytes, arrays, or shapes of FreeCAD, CadQuery, build123d, pythonocc and Netgen; see `af2.read`. Faces
and edges of models are numbered from 1, as in `af2 inspect`; points and elements of meshes are numbered from 0. All
lengths are in the unit of the model: millimetres for STEP and IGES. The guide is docs/python.md.
"""

from ._af2 import GeometryError, InputError, InternalError, Progress, Step
from ._af2 import version as __version__
from ._arguments import Layers
from ._errors import MeshError, RuleError
from ._groups import Group
from ._mesh import Mesh, Snapped
from ._meshing import mesh
from ._parts import Part
from ._models import Model, Planar, Surface, Triangles, read
from ._rules import Rules, load_rules, rule_names

__all__ = [
    "GeometryError", "Group", "InputError", "InternalError", "Layers", "Mesh", "MeshError", "Model", "Part", "Planar", "Progress",
    "RuleError", "Rules", "Snapped", "Step", "Surface", "Triangles", "__version__", "load_rules", "mesh", "read", "rule_names",
]
