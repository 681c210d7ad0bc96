"""Surfaces that Python code gives."""

import unittest

import numpy as np

import af2
from support import Case


class Saddle:
    """z = (x^2 - y^2) / 2 over a square."""

    bounds = ((-1, 1), (-1, 1))

    def evaluate(self, uv):
        return np.column_stack([uv, 0.5 * (uv[:, 0] ** 2 - uv[:, 1] ** 2)])

    def normal(self, uv):
        return np.column_stack([-uv[:, 0], uv[:, 1], np.ones(len(uv))])


def torus(uv):
    u, v = uv.T
    return np.column_stack([(3 + np.cos(v)) * np.cos(u), (3 + np.cos(v)) * np.sin(u), np.sin(v)])


def area(mesh):
    p = mesh.points[mesh.triangles]
    return 0.5 * np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1).sum()


class Surfaces(Case):
    def test_saddle(self):
        mesh = af2.mesh(Saddle(), size=0.15)
        x, y, z = mesh.points.T
        np.testing.assert_allclose(z, 0.5 * (x**2 - y**2), atol=1e-9)  # all points are on the surface
        self.assertTrue(mesh.complete)
        grid = np.linspace(-1, 1, 801)
        middles = 0.5 * (grid[1:] + grid[:-1])
        u, v = np.meshgrid(middles, middles)
        exact = np.sqrt(1 + u**2 + v**2).mean() * 4
        self.assertAlmostEqual(area(mesh), exact, delta=0.005 * exact)
        self.assertGreater(mesh.quality.min(), 0.5)
        self.assertAlmostEqual(len(mesh.triangles), exact / (0.433 * 0.15**2), delta=0.25 * len(mesh.triangles))

    def test_elements_look_to_the_side_of_the_normals(self):
        class Flipped(Saddle):
            def normal(self, uv):
                return -super().normal(uv)

        for surface, sign in ((Saddle(), 1), (Flipped(), -1)):
            mesh = af2.mesh(af2.Surface(surface, loops=[[(-1, -1), (1, -1), (1, 1), (-1, 1)][::sign]]), size=0.3)
            p = mesh.points[mesh.triangles]
            self.assertTrue(np.all(sign * np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])[:, 2] > 0))

    def test_function_without_normals_on_a_piece_of_a_torus(self):
        mesh = af2.mesh(af2.Surface(torus, ((0, 2), (0.5, 3))), size=0.35, chart="affine")
        x, y, z = mesh.points.T
        np.testing.assert_allclose((np.hypot(x, y) - 3) ** 2 + z**2, 1, atol=1e-9)
        v = np.linspace(0.5, 3, 2001)
        exact = 2 * np.trapz(3 + np.cos(v), v)
        self.assertAlmostEqual(area(mesh), exact, delta=0.02 * exact)

    def test_hole_in_the_parameters(self):
        turn = np.linspace(0, 2 * np.pi, 24, endpoint=False)[::-1]
        hole = 0.4 * np.column_stack([np.cos(turn), np.sin(turn)])
        mesh = af2.mesh(af2.Surface(Saddle(), loops=[[(-1, -1), (1, -1), (1, 1), (-1, 1)], hole]), size=0.15)
        self.assertGreater(np.linalg.norm(mesh.points[:, :2], axis=1).min(), 0.39)

    def test_sizes_charts_and_points(self):
        fingerprints = set()
        for chart in ("auto", "mean-normal", "affine", "parametric", "normal-lines"):
            mesh = af2.mesh(Saddle(), size=0.4, sizes=lambda p: 0.15 + 0.2 * np.abs(p[:, 0]), chart=chart)
            self.assertTrue(mesh.complete)
            fingerprints.add(mesh.fingerprint)
        self.assertGreater(len(fingerprints), 2)
        found = mesh.snap([(0.5, 0.2, 0.4)])
        self.assertAlmostEqual(found.points[0, 2], 0.5 * (found.points[0, 0] ** 2 - found.points[0, 1] ** 2), places=9)
        step = np.cross(np.array([0.5, 0.2, 0.4]) - found.points[0], found.normals[0])
        np.testing.assert_allclose(step, 0, atol=1e-6)  # the way there is along the normal
        np.testing.assert_allclose(mesh.evaluate(1, [(0.3, 0.1)]).points, [(0.3, 0.1, 0.04)])

    def test_quadrilaterals_and_second_order(self):
        mesh = af2.mesh(Saddle(), size=0.3, elements="quad")
        self.assertEqual(len(mesh.triangles), 0)
        mesh = af2.mesh(Saddle(), size=0.4, order=2)
        x, y, z = mesh.points.T
        np.testing.assert_allclose(z, 0.5 * (x**2 - y**2), atol=1e-6)

    def test_own_charts(self):
        made = []

        class Flat:
            """The parameters of the saddle as they are, moved, turned and scaled: x and y of its points."""

            def __init__(self, start, end, length):
                made.append(length)
                self.start = np.array(start[2])
                along = np.array(end[2]) - self.start
                self.axes = np.array([along, (-along[1], along[0])]) / np.linalg.norm(along)
                self.length = length

            def to_chart(self, points, normals, uv):
                return (uv - self.start) @ self.axes.T / self.length

            def to_surface(self, places):
                return self.start + self.length * places @ self.axes

        class Charted(Saddle):
            chart = Flat

        mesh = af2.mesh(Charted(), size=0.3)
        self.assertGreater(len(made), 50)
        self.assertEqual(mesh.faces[0].chart, "mean-normal")
        x, y, z = mesh.points.T
        np.testing.assert_allclose(z, 0.5 * (x**2 - y**2), atol=1e-9)

        class Shifted(Flat):
            def to_chart(self, points, normals, uv):
                return 1 + super().to_chart(points, normals, uv)

        Charted.chart = Shifted
        with self.assertRaisesRegex(ValueError, "start of the base edge"):
            af2.mesh(Charted(), size=0.3)

    def test_errors_after_meshing_are_raised(self):
        surface = Saddle()
        mesh = af2.mesh(surface, size=0.5)
        evaluate = Saddle.evaluate

        def fails(self, uv):
            raise OSError("gone")

        held = af2.Surface(lambda uv: surface.evaluate(uv), Saddle.bounds)
        other = af2.mesh(held, size=0.5)
        Saddle.evaluate = fails
        try:
            with self.assertRaisesRegex(OSError, "gone"):
                other.snap([(0, 0, 1)])
        finally:
            Saddle.evaluate = evaluate
        self.assertAlmostEqual(other.snap([(0, 0, 1)]).points[0, 2], mesh.snap([(0, 0, 1)]).points[0, 2])

    def test_errors_of_the_class_are_raised(self):
        class Broken(Saddle):
            def normal(self, uv):
                raise ZeroDivisionError("no normal here")

        with self.assertRaisesRegex(ZeroDivisionError, "no normal here"):
            af2.mesh(Broken(), size=0.3)

        class Wrong(Saddle):
            def evaluate(self, uv):
                return uv[:1]

        with self.assertRaisesRegex(ValueError, "evaluate"):
            af2.mesh(Wrong(), size=0.3)
        with self.assertRaisesRegex(af2.InputError, "bounds"):
            af2.Surface(torus, ((1, 0), (0, 1)))
        with self.assertRaises(TypeError):
            af2.Surface(3)


if __name__ == "__main__":
    unittest.main()
