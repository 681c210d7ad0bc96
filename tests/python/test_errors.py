"""What is wrong is said, with the argument, the place and the way out; an incomplete mesh does not pass silently."""

import pickle
import unittest

import numpy as np

import af2
from support import MODELS, Case

CYLINDER = MODELS / "cylinder.step"


class Arguments(Case):
    def refused(self, message, model=CYLINDER, error=af2.InputError, **arguments):
        with self.assertRaisesRegex(error, message):
            af2.mesh(model, **{"size": 1, **arguments})

    def test_sizes(self):
        self.refused("size: give the wanted edge length", size=None)
        for size in (0, -1, np.inf, np.nan, "1", True):
            self.refused("size", size=size)
        self.refused("is given as sizes=", size=lambda points: 1)
        self.refused("min_size=3.0 is above max_size=2.0", min_size=3, max_size=2)
        self.refused("at least 3 elements", curvature=2)
        self.refused("grading=11", grading=11)
        self.refused(r"face_sizes\[1\]=0", face_sizes={1: 0})
        self.refused("there is no face 9; the model has faces 1 to 3", face_sizes={9: 1})
        self.refused("there is no edge 99", edge_sizes={99: 1})
        self.refused("'inlet'", face_sizes={"inlet": 1})
        self.refused("expected a dictionary", face_sizes=[1])
        self.refused("sizes: expected a function", sizes=3)
        self.refused(r"sizes.*point", sizes={"point": []})
        self.refused("sizes", sizes={"points": [{"at": [0, 0, 0], "size": -1}]})

    def test_words(self):
        self.refused("choose 'any' or 'quad'", elements="quads")
        self.refused("choose 'fast', 'good' or 'best'", quality="better")
        self.refused("order 1 or 2", order=3)
        self.refused("choose one of auto", chart="flat")
        self.refused("1 to 4096", threads=-1)
        self.refused("choose 'first', 'last' or 'cut'", overlap="all", imprint=True)

    def test_combinations(self):
        self.refused("overlap needs imprint", overlap="cut")
        self.refused("imprint and glue exclude each other", imprint=True, glue=True)
        self.refused("leave out strict_rules", elements="quad", strict_rules=True)
        self.refused("make no quadrilaterals", elements="quad", rules="tri/even")
        self.refused("merge_narrow needs merge", merge_narrow=0.1)
        self.refused("cannot be combined", merge=True, fewest=True, chord=0.1)
        self.refused("fewest: give chord", fewest=True)
        self.refused("fewest is for triangles of order 1", fewest=True, chord=0.1, order=2)
        self.refused("heal is for CAD models", MODELS / "plate.poly", heal=True)
        self.refused("keep_boundary is for planar domains", keep_boundary=True)
        self.refused("feature_angle is for surfaces of triangles", feature_angle=30)
        self.refused("its own chart", MODELS / "plate.poly", chart="affine")

    def test_arrays(self):
        self.refused(r"points: the shape must be \(n, 2 or 3\), not \(1, 4\)", points=[(1, 2, 3, 4)])
        self.refused("there is no edge 99", boundary={99: [(0, 0, 0)]})
        self.refused("expected af2.Layers", layers=[(1, 2, 3)])
        self.refused("layers: count=0", layers=af2.Layers(0.1, count=0, edges=1))

    def test_models(self):
        self.refused("there is no such file", "nowhere.step")
        self.refused("is a folder", MODELS)
        self.refused("<bytes>: is empty", b"")
        self.refused("<bytes>: is not a STEP, IGES or BREP file", b"hello")
        self.refused("cannot mesh an object of type builtins.int", 7, TypeError)
        content = CYLINDER.read_bytes()
        self.refused("<bytes>", content[: len(content) // 3])
        self.refused("no model", (np.zeros((3, 3)), np.zeros((1, 2), int)))
        self.refused("triangle 0 refers to vertex 7; they are counted from 0 to 2", (np.eye(3), [[0, 1, 7]]))
        self.refused("expected whole numbers", (np.eye(3), [[0, 1, 1.5]]))
        self.refused("segment 0 refers to point 5; they are counted from 0 to 2", (np.eye(3, 2), [[0, 5]]))

    def test_writing(self):
        mesh = af2.mesh(CYLINDER, size=1)
        with self.assertRaisesRegex(af2.InputError, r"\.vtu"):
            mesh.write(self.folder / "x.docx")
        with self.assertRaisesRegex(af2.InputError, "nowhere"):
            mesh.write(self.folder / "nowhere" / "x.vtu")
        with self.assertRaisesRegex(af2.InputError, "no kind of group"):
            mesh.write(self.folder / "x.msh", groups=["bolts"])
        with self.assertRaisesRegex(af2.InputError, "exclude each other"):
            mesh.write(self.folder / "x.msh", scale=2, unit="m")
        with self.assertRaisesRegex(af2.InputError, "choose one of mm"):
            mesh.write(self.folder / "x.msh", unit="yard")
        self.assertEqual(list(self.folder.iterdir()), [])  # no half-written files

    def test_are_usual_errors_as_well(self):
        self.assertTrue(issubclass(af2.InputError, ValueError))
        self.assertTrue(issubclass(af2.RuleError, ValueError))
        self.assertTrue(issubclass(af2.MeshError, RuntimeError))


class Incomplete(Case):
    def damaged(self):
        """A cylinder of which one face has no surface."""
        lines = (MODELS / "cylinder.brep").read_text().splitlines()
        face = lines.index("Fa")
        lines[face + 1] = "0  1e-07 0 0"
        return "\n".join(lines).encode() + b"\n"

    def test_is_raised_with_the_rest_of_the_mesh(self):
        with self.assertRaises(af2.MeshError) as caught:
            af2.mesh(self.damaged(), size=1)
        error = caught.exception
        self.assertRegex(str(error), r"face 1 .* failed: the face has no surface")
        self.assertIn("allow_incomplete=True", str(error))
        self.assertGreater(len(error.mesh.elements), 50)
        self.assertEqual(error.mesh.failures[0].id, 1)
        self.assertEqual(error.mesh.failures[0].cause, "")

    def test_is_returned_if_allowed(self):
        mesh = af2.mesh(self.damaged(), size=1, allow_incomplete=True)
        self.assertFalse(mesh.complete)
        self.assertEqual(mesh.status, "partial")
        self.assertEqual(len(mesh.problems), 1)
        self.assertNotIn(1, mesh.face)
        self.assertIn("partial", repr(mesh))
        mesh.write_report(self.folder / "r.json")
        self.assertIn('"status": "partial"', (self.folder / "r.json").read_text())

    def test_triangles_in_a_mesh_of_quadrilaterals(self):
        odd = [(0, 0), (1, 0), (0.4, 1)]
        with self.assertRaisesRegex(af2.MeshError, "keeps .* triangle"):
            af2.mesh(af2.Planar(odd), size=2, elements="quad", keep_boundary=True)

    def test_a_chosen_face_is_complete(self):
        mesh = af2.mesh(self.damaged(), size=1, faces=[2, 3])
        self.assertTrue(mesh.complete)
        self.assertEqual(set(mesh.face), {2, 3})

    def test_errors_can_be_passed_between_processes(self):
        with self.assertRaises(af2.MeshError) as caught:
            af2.mesh(self.damaged(), size=1)
        self.assertIn("failed", str(pickle.loads(pickle.dumps(caught.exception))))


if __name__ == "__main__":
    unittest.main()
