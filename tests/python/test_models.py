"""Models: paths, bytes, arrays, planar domains, and shapes of other packages by fakes of their interfaces."""

import io
import pathlib
import sys
import types
import unittest
from unittest import mock

import numpy as np

import af2
from support import MODELS, Case

BREP = (MODELS / "die.brep").read_bytes()


class Bytes(Case):
    def test_are_read_by_content(self):
        by_path = af2.mesh(MODELS / "die.brep", size=1)
        self.assertEqual(af2.mesh(BREP, size=1).fingerprint, by_path.fingerprint)
        step = (MODELS / "die.step").read_bytes()
        self.assertEqual(af2.mesh(bytearray(step), size=1).fingerprint, af2.mesh(MODELS / "die.step", size=1).fingerprint)

    def test_nothing_is_left_behind(self):
        import tempfile

        with mock.patch.object(tempfile, "tempdir", str(self.folder)):
            af2.mesh(BREP, size=1)
            with self.assertRaises(af2.InputError):
                af2.mesh(b"nonsense", size=1)
        self.assertEqual(list(self.folder.iterdir()), [])


class Reading(Case):
    def test_parts(self):
        model = af2.read(MODELS / "cylinder.step")
        parts = model.parts()
        self.assertEqual((model.kind, model.unit), ("cad", "mm"))
        self.assertEqual([face.surface for face in parts.faces], ["cylinder", "plane", "plane"])
        self.assertEqual(sorted(edge.curve for edge in parts.edges), ["circle", "circle", "line"])
        self.assertEqual(parts.faces[0].edges, [edge.id for edge in parts.edges])

    def test_defects(self):
        self.assertEqual(af2.read(MODELS / "cylinder.step").defects(1), [])
        found = af2.read(MODELS / "cylinder.step").defects(100)
        self.assertIn("sliver", {defect.kind for defect in found})
        plate = af2.read(MODELS / "plate.poly").defects(50)
        self.assertEqual({defect.kind for defect in plate}, {"tiny edge", "sliver"})

    def test_contacts(self):
        contacts = af2.read(MODELS / "bolt_on_plate.brep").contacts()
        self.assertEqual((contacts.parts, len(contacts.pairs), contacts.not_compared), (2, 1, 0))
        self.assertEqual(contacts.pairs[0].kind, "touch")
        self.assertGreater(contacts.pairs[0].area, 0)
        self.assertEqual(af2.read(MODELS / "plate.poly").contacts().pairs, [])

    def test_is_done_once(self):
        model = af2.read(MODELS / "cylinder.step")
        self.assertIs(af2.read(model), model)
        coarse, fine = af2.mesh(model, 2), af2.mesh(model, 0.5)
        self.assertGreater(len(fine.elements), 4 * len(coarse.elements))


class Triangles(Case):
    def cube(self):
        corners = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
        quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
        return corners, np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])

    def test_are_meshed(self):
        mesh = af2.mesh(self.cube(), size=0.25)
        self.assertEqual(len(mesh.faces), 6)
        self.assertEqual(mesh.measures.free_edges, 0)
        corners = mesh.points[mesh.triangles]
        volume = np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
        self.assertAlmostEqual(volume, 1)

    def test_parts_become_groups(self):
        vertices, triangles = self.cube()
        model = af2.Triangles(vertices, triangles, parts=np.repeat(np.arange(6), 2),
                              part_names=["west", "east", "south", "north", "bottom", "top"])
        top = af2.mesh(model, 0.25).group("top")
        self.assertTrue(np.allclose(top._mesh.points[top._mesh.elements[top.elements, :3], 2], 1))

    def test_any_whole_numbers(self):
        vertices, triangles = self.cube()
        made = {af2.mesh((vertices.astype(np.float32), triangles.astype(kind)), size=0.25).fingerprint
                for kind in (np.uint8, np.int32, np.uint64)}
        self.assertEqual(len(made), 1)


class Planar(Case):
    SQUARE = [(0, 0), (4, 0), (4, 3), (0, 3)]
    HOLE = [(2 + 0.5 * np.cos(t), 1.5 + 0.5 * np.sin(t)) for t in np.linspace(0, 2 * np.pi, 24, endpoint=False)]

    def area(self, mesh):
        p = mesh.points[mesh.triangles]
        return 0.5 * np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])[:, 2].sum()

    def test_polygon_with_a_hole(self):
        mesh = af2.mesh(af2.Planar(self.SQUARE, holes=[self.HOLE]), size=0.3)
        self.assertAlmostEqual(self.area(mesh), 12 - 12 * 0.5**2 * np.sin(2 * np.pi / 24), places=9)

    def test_hole_that_is_not_convex(self):
        hole = np.array([(1, 1), (3, 1), (3, 2), (2.9, 2), (2.9, 1.1), (1, 1.1)])
        mesh = af2.mesh(af2.Planar(self.SQUARE, holes=[hole]), size=0.3)
        self.assertAlmostEqual(self.area(mesh), 12 - 0.2 - 0.09, places=9)

    def test_segments_regions_and_boundaries(self):
        points = [*self.SQUARE, (2, 0), (2, 3)]
        segments = [(0, 4), (4, 1), (1, 2), (2, 5), (5, 3), (3, 0), (4, 5)]
        domain = af2.Planar(points, segments, regions={"left": (1, 1), "right": (3, 1)}, region_sizes={"right": 0.1},
                            markers=[1, 1, 2, 0, 0, 3, 0], boundary_names={1: "bottom", 2: "outlet"})
        mesh = af2.mesh(domain, size=0.5)
        left, right = mesh.group("left"), mesh.group("right")
        self.assertGreater(len(right.elements), 5 * len(left.elements))
        self.assertTrue(np.all(mesh.points[mesh.elements[left.elements, :3], 0] <= 2))
        self.assertTrue(np.allclose(mesh.points[mesh.group("outlet").segments, 0], 4))
        self.assertEqual(mesh.group("3").number, 3)
        self.assertEqual([group.label for group in mesh.groups], ["left", "right", "bottom", "outlet", "boundary 3"])
        mesh.write(self.folder / "x.msh")
        for label in ("left", "outlet", "boundary 3"):
            self.assertIn(f'"{label}"'.encode(), (self.folder / "x.msh").read_bytes())

    def test_tuple_of_arrays(self):
        segments = [(0, 1), (1, 2), (2, 3), (3, 0)]
        mesh = af2.mesh((np.array(self.SQUARE, float), segments), size=0.5)
        self.assertAlmostEqual(self.area(mesh), 12)
        self.assertEqual(mesh.fingerprint, af2.mesh(af2.Planar(self.SQUARE), size=0.5).fingerprint)

    def test_faults(self):
        for message, make in {
            "cross": lambda: af2.mesh(af2.Planar([(0, 0), (1, 1), (1, 0), (0, 1)]), size=0.2),
            "at least three points": lambda: af2.Planar([(0, 0), (1, 1)]),
            "on one line": lambda: af2.Planar(self.SQUARE, holes=[[(1, 1), (2, 1), (3, 1)]]),
            "no region 'x'": lambda: af2.Planar(self.SQUARE, region_sizes={"x": 1}),
            "there are 2 for 4 segments": lambda: af2.Planar(self.SQUARE, markers=[1, 2]),
        }.items():
            with self.assertRaisesRegex(af2.InputError, message):
                make()


def fake_module(name, **content):
    """A module of a package that is not installed, for the time of a test."""
    module = types.ModuleType(name)
    for key, value in content.items():
        if isinstance(value, type):
            value.__module__ = name
        setattr(module, key, value)
    return module


class Shapes(Case):
    """Each fake has the functions that the package in question really has, and no others."""

    def with_modules(self, **modules):
        patch = mock.patch.dict(sys.modules, {name.replace("_", "."): m for name, m in modules.items()})
        patch.start()
        self.addCleanup(patch.stop)

    def is_die(self, shape):
        made = af2.mesh(shape, size=1)
        self.assertEqual(made.fingerprint, af2.mesh(BREP, size=1).fingerprint)
        return made

    def cadquery(self):
        class Shape:
            def __init__(self, content=BREP):
                self.content = content

            def exportBrep(self, f):
                f.write(self.content) if isinstance(f, io.BytesIO) else pathlib.Path(f).write_bytes(self.content)
                return True

        class Compound(Shape):
            made_of = []

            @classmethod
            def makeCompound(cls, shapes):
                cls.made_of.append(len(shapes))
                return cls(shapes[0].content)

        class Workplane:
            def __init__(self, *objects):
                self.objects = list(objects)

            def vals(self):
                return self.objects

            def val(self):
                return self.objects[0]

        class Assembly:
            def toCompound(self):
                return Compound()

        shapes = fake_module("cadquery.occ_impl.shapes", Shape=Shape, Compound=Compound)
        self.with_modules(**{"cadquery_occ_impl_shapes": None})
        sys.modules["cadquery.occ_impl.shapes"] = shapes
        self.addCleanup(sys.modules.pop, "cadquery.occ_impl.shapes", None)
        return Shape, Workplane, Assembly

    def test_cadquery(self):
        Shape, Workplane, Assembly = self.cadquery()
        self.assertEqual(self.is_die(Shape()).name, "<Shape>")
        self.is_die(Workplane(Shape()))
        self.is_die(Workplane(Shape(), object(), Shape()))  # the two shapes become a compound
        self.assertEqual(sys.modules["cadquery.occ_impl.shapes"].Compound.made_of, [2])
        self.is_die(Assembly())
        with self.assertRaisesRegex(af2.InputError, "workplane has no shape"):
            af2.mesh(Workplane(), size=1)

    def test_freecad(self):
        class Shape:
            def __init__(self, content=BREP):
                self.content = content

            def isNull(self):
                return not self.content

            def exportBrep(self, f):
                f.write(self.content)

        class Feature:
            Label = "Die"

            def __init__(self, shape):
                self.Shape = shape

        self.is_die(Shape())
        self.is_die(Feature(Shape()))
        with self.assertRaisesRegex(af2.InputError, "the object 'Die' of FreeCAD has no shape"):
            af2.mesh(Feature(Shape(b"")), size=1)
        with self.assertRaisesRegex(TypeError, "cannot mesh an object"):
            af2.mesh(Feature(None), size=1)

    def test_old_cadquery_writes_files_only(self):
        class Shape:
            def exportBrep(self, fileName):
                if not isinstance(fileName, str):
                    raise TypeError("incompatible function arguments")
                pathlib.Path(fileName).write_bytes(BREP)
                return True

        self.is_die(Shape())

    def test_build123d(self):
        class Part:
            wrapped = object()

        class BuildPart:
            part = Part()

        def export_brep(to_export, file_path):
            assert isinstance(to_export, Part)
            pathlib.Path(file_path).write_bytes(BREP)
            return True

        self.with_modules(build123d=fake_module("build123d", Part=Part, BuildPart=BuildPart, export_brep=export_brep))
        self.is_die(Part())
        self.is_die(BuildPart())

    def test_ocp(self):
        class TopoDS_Solid:
            pass

        class BRepTools:
            @staticmethod
            def Write_s(shape, path):
                assert type(shape).__name__ == "TopoDS_Solid"
                pathlib.Path(path).write_bytes(BREP)
                return True

        class Wrapper:  # of a package that is not known
            wrapped = TopoDS_Solid()

        self.with_modules(OCP=fake_module("OCP"), OCP_TopoDS=fake_module("OCP.TopoDS", TopoDS_Solid=TopoDS_Solid),
                          OCP_BRepTools=fake_module("OCP.BRepTools", BRepTools=BRepTools))
        self.is_die(TopoDS_Solid())
        self.is_die(Wrapper())

    def test_pythonocc(self):
        class TopoDS_Shape:
            pass

        def write(shape, path):
            pathlib.Path(path).write_bytes(BREP)
            return True

        now = types.SimpleNamespace(Write=write)
        for functions in ({"breptools": now}, {"breptools_Write": write}):
            tools = fake_module("OCC.Core.BRepTools", **functions)
            self.with_modules(OCC=fake_module("OCC"), OCC_Core=fake_module("OCC.Core", BRepTools=tools),
                              OCC_Core_BRepTools=tools, OCC_Core_TopoDS=fake_module("OCC.Core.TopoDS", TopoDS_Shape=TopoDS_Shape))
            self.is_die(TopoDS_Shape())

    def test_netgen(self):
        class Solid:
            def WriteBrep(self, filename):
                pathlib.Path(filename).write_bytes(BREP)

            def WriteStep(self, filename):
                raise AssertionError("BREP keeps the faces in their order")

        class OCCGeometry:
            shape = Solid()

            def GenerateMesh(self, **options):
                raise AssertionError("AF2 makes the mesh")

        self.is_die(Solid())
        self.is_die(OCCGeometry())

    def test_old_netgen_has_step_only(self):
        class Solid:
            def WriteStep(self, filename):
                pathlib.Path(filename).write_bytes((MODELS / "die.step").read_bytes())

        self.assertEqual(af2.mesh(Solid(), size=1).fingerprint, af2.mesh(MODELS / "die.step", size=1).fingerprint)

    def test_faces_keep_their_order(self):
        Shape, _, _ = self.cadquery()
        parts = af2.read(Shape()).parts().faces
        self.assertEqual([(f.id, f.surface, f.area) for f in parts],
                         [(f.id, f.surface, f.area) for f in af2.read(MODELS / "die.brep").parts().faces])

    def test_faces_get_names(self):
        Shape, _, _ = self.cadquery()
        mesh = af2.mesh(Shape(), size=1, names={"top": 1, "pips": np.array([2, 3])}, face_sizes={"top": 0.3})
        self.assertEqual(mesh.faces[0].name, "top")
        self.assertEqual(mesh.group("pips").faces, [2, 3])
        self.assertGreater((mesh.face == 1).sum(), 1.5 * (af2.mesh(BREP, size=1).face == 1).sum())
        mesh.write(self.folder / "named.msh")
        content = (self.folder / "named.msh").read_bytes()
        self.assertIn(b'"pips"', content)
        self.assertIn(b'"top"', content)
        with self.assertRaisesRegex(af2.InputError, "'top' is for face 999"):
            af2.read(BREP, names={"top": 999})
        with self.assertRaisesRegex(af2.InputError, "names are for CAD models"):
            af2.read(MODELS / "plate.poly", names={"top": 1})

    def test_a_failing_export_is_told(self):
        class Shape:
            def exportBrep(self, f):
                return False

        with self.assertRaisesRegex(af2.InputError, "could not be written as a BREP file"):
            af2.mesh(Shape(), size=1)


if __name__ == "__main__":
    unittest.main()
