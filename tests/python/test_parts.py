"""Meshes divided into parts, as programs with many processes need them."""

import pickle
import unittest

import numpy as np

import af2
from support import MODELS, Case


def areas(points, elements):
    """Of triangles."""
    corners = points[elements[:, :3]]
    return np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2


class Parts(Case):
    @classmethod
    def setUpClass(cls):
        cls.mesh = af2.mesh(MODELS / "cylinder.step", size=0.8)
        cls.parts = cls.mesh.parts(4, edges=True)

    def test_each_element_point_and_line_is_owned_once(self):
        for ids, owned, whole in (("element_ids", "owned_elements", len(self.mesh.elements)),
                                  ("point_ids", "owned_points", len(self.mesh.points))):
            own = np.concatenate([getattr(part, ids)[:getattr(part, owned)] for part in self.parts])
            np.testing.assert_array_equal(np.sort(own), np.arange(whole))
        lines = np.concatenate([part.line_ids for part in self.parts])
        np.testing.assert_array_equal(np.sort(lines), np.arange(len(lines)))
        self.assertEqual(len(lines), len(self.mesh.segments))

    def test_they_are_about_the_same_size(self):
        for part in self.parts:
            self.assertAlmostEqual(part.owned_elements / len(self.mesh.elements), 0.25, delta=0.05)

    def test_points_and_corners_are_those_of_the_mesh(self):
        for number, part in enumerate(self.parts):
            self.assertEqual((part.part, part.parts), (number, 4))
            np.testing.assert_array_equal(part.points, self.mesh.points[part.point_ids])
            corners = part.point_ids[part.elements[:, :3]]
            np.testing.assert_array_equal(corners, self.mesh.elements[part.element_ids, :3])
            np.testing.assert_array_equal(part.face, self.mesh.face[part.element_ids])
            self.assertTrue(np.all(part.elements[:, 3] == -1))
            self.assertTrue(np.all(part.element_owners[:part.owned_elements] == number))
            self.assertTrue(np.all(part.element_owners[part.owned_elements:] != number))

    def test_numbers_follow_each_other_in_each_part(self):
        begin = 0
        for part in self.parts:
            own = part.point_numbers[:part.owned_points]
            np.testing.assert_array_equal(own, np.arange(begin, begin + part.owned_points))
            begin += part.owned_points

    def test_ghosts_make_sums_at_own_points_complete(self):
        whole = np.zeros(len(self.mesh.points))
        np.add.at(whole, self.mesh.triangles, areas(self.mesh.points, self.mesh.triangles)[:, None] / 3)
        for part in self.parts:
            sums = np.zeros(len(part.points))
            np.add.at(sums, part.elements[:, :3], areas(part.points, part.elements)[:, None] / 3)
            own = slice(part.owned_points)
            np.testing.assert_allclose(sums[own], whole[part.point_ids[own]], rtol=1e-12)

    def test_ghosts_are_told_to_their_owners(self):
        wanted = {(other.part, int(e)) for other in self.parts for e in other.element_ids[other.owned_elements:]}
        told = {(int(other), int(part.element_ids[e])) for part in self.parts for e in range(part.owned_elements)
                for other in part.ghosts_of[part.ghosts_begin[e]:part.ghosts_begin[e + 1]]}
        self.assertEqual(told, wanted)

    def test_quadrilaterals_and_second_order(self):
        mesh = af2.mesh(MODELS / "plate.poly", size=0.5, elements="quad", order=2)
        for part in mesh.parts(3):
            self.assertTrue(np.all(part.elements >= 0))
            np.testing.assert_array_equal(part.point_ids[part.midsides], mesh.midsides[part.element_ids])

    def test_they_can_be_sent(self):
        part = pickle.loads(pickle.dumps(self.parts[2]))
        np.testing.assert_array_equal(part.elements, self.parts[2].elements)
        self.assertEqual(part.owned_points, self.parts[2].owned_points)

    def test_one_part_is_the_mesh(self):
        part, = self.mesh.parts(1)
        self.assertEqual(repr(part), f"<af2.Part 0 of 1: {len(self.mesh.elements)} elements, 0 ghosts>")
        np.testing.assert_array_equal(part.points, self.mesh.points)
        np.testing.assert_array_equal(part.elements, self.mesh.elements)

    def test_no_parts_are_refused(self):
        with self.assertRaisesRegex(af2.InputError, "at least 1"):
            self.mesh.parts(0)
        with self.assertRaises(TypeError):
            self.mesh.parts(1.5)


if __name__ == "__main__":
    unittest.main()
