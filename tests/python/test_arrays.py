"""Arrays over the memory of a mesh: shapes, types, no copies, and a life of their own."""

import gc
import unittest
import weakref

import numpy as np

import af2
from support import MODELS, Case


def address(array):
    return array.__array_interface__["data"][0]


class Arrays(Case):
    @classmethod
    def setUpClass(cls):
        cls.mesh = af2.mesh(MODELS / "die.step", size=0.8)

    def test_shapes_and_types(self):
        mesh, n, m = self.mesh, len(self.mesh.points), len(self.mesh.elements)
        expected = {"points": ((n, 3), "f8"), "elements": ((m, 4), "i4"), "triangles": ((m, 3), "i4"), "quads": ((0, 4), "i4"),
                    "face": ((m,), "i4"), "rule": ((m,), "u2"), "level": ((m,), "u1"), "changed": ((m,), "?"),
                    "quality": ((m,), "f8"), "scores": ((m,), "f4"), "wanted_sizes": ((n,), "f8"),
                    "midsides": ((0, 4), "i4"), "segments": ((len(mesh.segments), 2), "i4")}
        for name, (shape, kind) in expected.items():
            array = getattr(mesh, name)
            self.assertEqual((array.shape, array.dtype), (shape, np.dtype(kind)), name)

    def test_nothing_is_copied(self):
        for name in ("points", "elements", "triangles", "face", "rule", "level", "changed", "quality", "scores",
                     "wanted_sizes", "segments", "segment_edges"):
            first, again = getattr(self.mesh, name), getattr(self.mesh, name)
            self.assertEqual(address(first), address(again), name)
            self.assertIs(first.base, self.mesh._data, name)
            self.assertFalse(first.flags.owndata, name)
        self.assertEqual(address(self.mesh.triangles), address(self.mesh.elements))

    def test_arrays_are_read_only(self):
        with self.assertRaises(ValueError):
            self.mesh.points[0, 0] = 1
        with self.assertRaises(ValueError):
            self.mesh.points.flags.writeable = True

    def test_arrays_keep_the_mesh_alive(self):
        mesh = af2.mesh(MODELS / "cylinder.step", size=1)
        points, before = mesh.points, mesh.points.copy()
        watched = weakref.ref(mesh)
        del mesh
        gc.collect()
        self.assertIsNone(watched())
        af2.mesh(MODELS / "cylinder.step", size=1)  # would take the memory if it were free
        np.testing.assert_array_equal(points, before)

    def test_indices_are_those_of_points(self):
        corners = self.mesh.points[self.mesh.triangles]
        area = 0.5 * np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum()
        self.assertAlmostEqual(area, sum(face.area for face in self.mesh.faces), delta=0.02 * area)
        self.assertEqual(np.unique(self.mesh.triangles).size, len(self.mesh.points))

    def test_kinds_of_a_mixed_mesh(self):
        mesh = af2.mesh(MODELS / "plate.poly", size=0.5, rules="quad/classic")
        self.assertGreater(len(mesh.quads), 0)
        self.assertEqual(len(mesh.quads) + len(mesh.triangles), len(mesh.elements))
        np.testing.assert_array_equal(mesh.elements[mesh.is_quad], mesh.quads)
        self.assertTrue(np.all(mesh.elements[~mesh.is_quad, 3] == -1))
        self.assertEqual(address(mesh.quads), address(mesh.quads))  # made once

    def test_second_order(self):
        mesh = af2.mesh(MODELS / "cylinder.step", size=1, order=2)
        self.assertEqual(mesh.order, 2)
        self.assertEqual(mesh.midsides.shape, (len(mesh.elements), 4))
        middles = mesh.points[mesh.midsides[:, 0]]
        chords = mesh.points[mesh.elements[:, :2]].mean(axis=1)
        self.assertLess(np.abs(middles - chords).max(), 0.2)
        self.assertGreater(np.abs(middles - chords).max(), 1e-3)  # on the cylinder, not on its chords

    def test_quality_is_that_of_the_report(self):
        self.assertAlmostEqual(self.mesh.quality.min(), self.mesh.measures.min)
        self.assertAlmostEqual(self.mesh.quality.mean(), self.mesh.measures.mean)

    def test_groups(self):
        mesh = af2.mesh(MODELS / "bolt_on_plate.brep", size=0.6)
        solids = [group for group in mesh.groups if group.kind == "solid"]
        self.assertEqual(len(solids), 2)
        parts = np.concatenate([solid.elements for solid in solids])
        np.testing.assert_array_equal(np.sort(parts), np.arange(len(mesh.elements)))
        self.assertEqual(mesh.group(solids[0].name).faces, solids[0].faces)
        with self.assertRaisesRegex(KeyError, "no group 'outlet'"):
            mesh.group("outlet")

    def test_every_element_has_its_face_and_rule(self):
        self.assertEqual(set(self.mesh.face), {face.id for face in self.mesh.faces})
        self.assertTrue(np.all(self.mesh.rule < len(self.mesh.rule_names)))
        counts = np.bincount(self.mesh.face, minlength=len(self.mesh.faces) + 1)[1:]
        self.assertEqual(counts.tolist(), [face.elements for face in self.mesh.faces])


if __name__ == "__main__":
    unittest.main()
