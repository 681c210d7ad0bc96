"""Points of the model: the nearest ones, and those with given parameters."""

import unittest

import numpy as np

import af2
from support import MODELS, Case


class CadModels(Case):
    @classmethod
    def setUpClass(cls):
        cls.mesh = af2.mesh(MODELS / "cylinder.step", size=0.7)
        cls.side = next(face.id for face in cls.mesh.faces if face.surface == "cylinder")
        curved = cls.mesh.points[cls.mesh.elements[cls.mesh.face == cls.side, :3]]
        cls.radius = np.linalg.norm(curved.reshape(-1, 3)[:, :2], axis=1).max()
        cls.height = np.ptp(cls.mesh.points[:, 2])

    def test_middles_of_elements_come_onto_the_surface(self):
        chosen = self.mesh.face == self.side
        middles = self.mesh.points[self.mesh.triangles[chosen]].mean(axis=1)
        found = self.mesh.snap(middles, self.mesh.face[chosen])
        np.testing.assert_allclose(np.linalg.norm(found.points[:, :2], axis=1), self.radius, rtol=1e-9)
        np.testing.assert_allclose(np.linalg.norm(found.points - middles, axis=1), found.distances, atol=1e-12)
        self.assertTrue(np.all(found.faces == self.side))
        outwards = found.points * [1, 1, 0] / self.radius
        np.testing.assert_allclose(found.normals, outwards, atol=1e-9)
        np.testing.assert_allclose(self.mesh.snap(middles).points, found.points, atol=1e-9)  # on all faces

    def test_beyond_an_edge_the_edge_is_nearest(self):
        top = self.mesh.points[:, 2].max()
        found = self.mesh.snap([(2 * self.radius, 0, top + 1)])
        np.testing.assert_allclose(found.points, [(self.radius, 0, top)], atol=1e-7)
        found = self.mesh.snap([(self.radius / 3, 0, top + 1)], self.side)  # of that face alone
        np.testing.assert_allclose(found.points, [(self.radius, 0, top)], atol=1e-6)

    def test_points_of_the_mesh_stay(self):
        found = self.mesh.snap(self.mesh.points)
        self.assertLess(found.distances.max(), 1e-7)
        np.testing.assert_allclose(found.points, self.mesh.points, atol=1e-7)

    def test_threads_do_not_matter(self):
        places = self.mesh.points * 1.3
        alone = self.mesh.snap(places, threads=1)
        for field, other in zip(alone, self.mesh.snap(places, threads=3)):
            np.testing.assert_array_equal(field, other)

    def test_parameters_go_back_and_forth(self):
        places = self.mesh.points[np.unique(self.mesh.elements[self.mesh.face == self.side, :3])]
        found = self.mesh.snap(places, self.side)
        again = self.mesh.evaluate(self.side, found.uv)
        np.testing.assert_allclose(again.points, found.points, atol=1e-9)
        np.testing.assert_allclose(again.normals, found.normals, atol=1e-9)

    def test_second_order_vertices_are_snapped_middles(self):
        mesh = af2.mesh(MODELS / "die.step", size=0.9, order=2)
        inside = mesh.midsides[:, 0]
        found = mesh.snap(mesh.points[inside], mesh.face)
        self.assertLess(found.distances.max(), 1e-5)  # the tolerance of the edges

    def test_faults(self):
        with self.assertRaisesRegex(af2.InputError, "no face 9"):
            self.mesh.snap([(0, 0, 0)], 9)
        with self.assertRaisesRegex(af2.InputError, "no finite number"):
            self.mesh.snap([(np.nan, 0, 0)])
        with self.assertRaisesRegex(af2.InputError, "no point with the parameters"):
            self.mesh.evaluate(self.side, [(0, np.inf)])
        with self.assertRaisesRegex(af2.InputError, "no point with the parameters"):
            af2.mesh(MODELS / "hills.brep", size=3).evaluate(1, [(1e9, 0)])
        with self.assertRaisesRegex(af2.InputError, "shape must be"):
            self.mesh.snap(np.zeros((2, 5)))


class OtherModels(Case):
    def test_planar_domains(self):
        mesh = af2.mesh(af2.Planar([(0, 0), (4, 0), (4, 3), (0, 3)], holes=[[(1, 1), (2, 1), (2, 2), (1, 2)]]), size=0.4)
        found = mesh.snap([(0.5, 0.5), (5, 1), (1.4, 1.5), (-1, -1)])
        np.testing.assert_allclose(found.points[:, :2], [(0.5, 0.5), (4, 1), (1, 1.5), (0, 0)], atol=1e-9)
        np.testing.assert_allclose(mesh.evaluate(1, [(0.25, 2)]).points, [(0.25, 2, 0)])
        with self.assertRaisesRegex(af2.InputError, "no face 2"):
            mesh.evaluate(2, [(0, 0)])

    def test_triangles(self):
        sphere = af2.mesh(MODELS / "die.step", size=0.5)
        again = af2.mesh((sphere.points, sphere.triangles), size=0.8)
        found = again.snap(again.points)
        self.assertLess(found.distances.max(), 1e-9)
        inside = again.snap(again.points.mean(axis=0)[np.newaxis])
        self.assertGreater(inside.distances[0], 0.5)
        with self.assertRaisesRegex(af2.InputError, "no parameters"):
            again.evaluate(1, [(0, 0)])


if __name__ == "__main__":
    unittest.main()
