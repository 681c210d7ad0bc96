"""Files, pages in notebooks, and objects of other packages."""

import json
import sys
import unittest
from unittest import mock

import numpy as np

import af2
from support import MODELS, Case


class Files(Case):
    @classmethod
    def setUpClass(cls):
        cls.mesh = af2.mesh(MODELS / "brickhole.step", size=1)

    def test_report(self):
        self.mesh.write_report(self.folder / "mine.json")
        self.program("mesh", MODELS / "brickhole.step", "--size", 1, "-q", "--report", "program.json")
        mine, program = (json.loads((self.folder / name).read_text()) for name in ("mine.json", "program.json"))
        for key in ("seconds", "contacts", "stuck"):
            mine.pop(key, None), program.pop(key, None)
        for report in (mine, program):
            for face in report["faces"]:
                face.pop("seconds")
        self.assertEqual(mine, program)

    def test_page(self):
        page = self.mesh.html()
        self.assertTrue(page.lstrip().lower().startswith("<!doctype html"))
        self.assertIn("brickhole.step", page)
        frame = self.mesh._repr_html_()
        self.assertTrue(frame.startswith("<iframe srcdoc="))
        self.assertNotIn('"<', frame[len('<iframe srcdoc="'):frame.rindex('" style')])  # nothing ends the attribute

    def test_meshio(self):
        try:
            import meshio
        except ImportError:
            self.skipTest("meshio is not installed")
        mixed = af2.mesh(MODELS / "plate.poly", size=0.5, rules="quad/classic")
        made = mixed.to_meshio()
        self.assertIsInstance(made, meshio.Mesh)
        self.assertEqual({block.type: len(block.data) for block in made.cells},
                         {"triangle": len(mixed.triangles), "quad": len(mixed.quads)} if len(mixed.triangles) else
                         {"quad": len(mixed.quads)})
        self.assertTrue(np.shares_memory(self.mesh.to_meshio().points, self.mesh.points))
        self.assertTrue(np.shares_memory(self.mesh.to_meshio().cells[0].data, self.mesh.elements))
        solids = af2.mesh(MODELS / "bolt_on_plate.brep", size=0.8)
        sets = solids.to_meshio().cell_sets
        np.testing.assert_array_equal(sets["solid 2"][0], solids.group("solid 2").elements)
        made.write(self.folder / "x.vtk")
        self.assertEqual(len(meshio.read(self.folder / "x.vtk").points), len(mixed.points))
        second = af2.mesh(MODELS / "cylinder.step", size=1, order=2).to_meshio()
        self.assertEqual(second.cells[0].type, "triangle6")
        middle = second.points[second.cells[0].data[:, 3]]
        ends = second.points[second.cells[0].data[:, :2]]
        self.assertLess(np.linalg.norm(middle - ends.mean(axis=1), axis=1).max(),
                        0.3 * np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).max())

    def test_missing_packages_are_named(self):
        with mock.patch.dict(sys.modules, {"meshio": None, "pyvista": None}):
            with self.assertRaisesRegex(ImportError, "to_meshio needs meshio"):
                self.mesh.to_meshio()
            with self.assertRaisesRegex(ImportError, "to_pyvista needs PyVista"):
                self.mesh.to_pyvista()

    def test_pyvista(self):
        """PyVista is not in Debian: a fake takes what its UnstructuredGrid takes, a dictionary of cells by VTK's type."""
        class UnstructuredGrid:
            def __init__(self, cells, points):
                assert set(cells) <= {5, 9, 22, 23} and all(c.ndim == 2 for c in cells.values())
                self.cells, self.points, self.cell_data = cells, points, {}

        fake = mock.MagicMock(UnstructuredGrid=UnstructuredGrid)
        mixed = af2.mesh(MODELS / "plate.poly", size=0.5, rules="quad/classic")
        with mock.patch.dict(sys.modules, {"pyvista": fake}):
            grid = mixed.to_pyvista()
        self.assertEqual(sum(map(len, grid.cells.values())), len(mixed.elements))
        self.assertTrue(np.shares_memory(grid.points, mixed.points))
        self.assertEqual(len(grid.cell_data["quality"]), len(mixed.elements))
        np.testing.assert_allclose(grid.cell_data["quality"][-len(mixed.quads):], mixed.quality[mixed.is_quad])


class Stubs(Case):
    def test_every_public_name_is_documented(self):
        import inspect

        for name in af2.__all__:
            thing = getattr(af2, name)
            if name.startswith("__"):
                continue
            self.assertTrue(inspect.getdoc(thing), name)
            if not inspect.isclass(thing) or thing.__module__ == "af2._af2":  # these have one text for all members
                continue
            for member, value in vars(thing).items():
                if not member.startswith("_") and (inspect.isfunction(value) or isinstance(value, property)):
                    self.assertTrue(inspect.getdoc(value), f"{name}.{member}")

    def test_stubs_name_what_the_module_has(self):
        import ast
        import pathlib

        from af2 import _af2

        stub = pathlib.Path(af2.__file__).parent / "_af2.pyi"
        named = {}
        for node in ast.parse(stub.read_text()).body:
            if isinstance(node, ast.ClassDef):
                named[node.name] = {part.target.id if isinstance(part, ast.AnnAssign) else part.name for part in node.body
                                    if isinstance(part, (ast.AnnAssign, ast.FunctionDef))}
            elif isinstance(node, ast.FunctionDef):
                named[node.name] = None
            elif isinstance(node, ast.AnnAssign):
                named[node.target.id] = None
        real = {name for name in vars(_af2) if not name.startswith("__")}
        self.assertEqual(set(named), real)
        for name, members in named.items():
            if members is not None and not issubclass(getattr(_af2, name), Exception):
                own = {m for m in vars(getattr(_af2, name)) if not m.startswith("_")}
                self.assertEqual({m for m in members if not m.startswith("_")}, own, name)
        self.assertTrue((stub.parent / "py.typed").exists())


if __name__ == "__main__":
    unittest.main()
