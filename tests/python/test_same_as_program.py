"""The package makes the meshes that the program makes, byte for byte."""

import unittest

import numpy as np

import af2
from support import MODELS, Case


class SameAsProgram(Case):
    def test_all_formats(self):
        mesh = af2.mesh(MODELS / "die.step", size=1)
        for extension in (e for e, _ in af2._af2.mesh_formats() if e not in (".smesh",)):
            with self.subTest(extension):
                if extension == ".svg":  # for planar meshes
                    self.assertRaises(af2.InputError, mesh.write, self.folder / "x.svg")
                    continue
                self.same_bytes(mesh, "die" + extension, MODELS / "die.step", "--size", 1)

    def test_sizes_of_parts(self):
        mesh = af2.mesh(MODELS / "brickhole.step", size=1, face_sizes={1: 0.25, (2, 3): 0.5}, edge_sizes={4: 0.2},
                        curvature=20, min_size=0.1, max_size=0.9, grading=0.2, proximity=2)
        self.same_bytes(mesh, "brick.vtu", MODELS / "brickhole.step", "--size", 1, "--face-size", "1=0.25", "--face-size",
                        "2-3=0.5", "--edge-size", "4=0.2", "--curvature", 20, "--min-size", 0.1, "--max-size", 0.9,
                        "--grading", 0.2, "--proximity", 2)

    def test_size_sources(self):
        sizes = {"points": [{"at": np.zeros(3), "size": np.float64(0.2)}], "parts": {"*": 0.9}}
        (self.folder / "sizes.json").write_text('{"points": [{"at": [0, 0, 0], "size": 0.2}], "parts": {"*": 0.9}}')
        mesh = af2.mesh(MODELS / "cylinder.step", size=1, sizes=sizes)
        self.same_bytes(mesh, "sized.vtu", MODELS / "cylinder.step", "--size", 1, "--sizes", "sizes.json")

    def test_size_fields(self):
        (self.folder / "field.pos").write_text('View "h" { SL(0, 0, 0, 4, 0, 0){0.1, 0.5}; };')
        plate = MODELS / "plate.poly"
        mesh = af2.mesh(plate, size=0.5, size_fields=self.folder / "field.pos")
        self.assertGreater(len(mesh.triangles), len(af2.mesh(plate, size=0.5).triangles))
        self.same_bytes(mesh, "field.vtu", plate, "--size", 0.5, "--size-field", "field.pos")

    def test_coarsening(self):
        brick = MODELS / "brickhole.step"
        with self.assertRaisesRegex(af2.InputError, "times as large"):
            af2.mesh(brick, size=0.02, max_memory=10**6)
        mesh = af2.mesh(brick, size=0.02, max_memory=10**6, coarsen=True)
        self.assertTrue(any("times as large" in note for note in mesh.notes))
        self.assertLess(len(mesh.triangles), 12000)

    def test_quads(self):
        mesh = af2.mesh(MODELS / "brickhole.step", size=0.7, elements="quad", quality="best")
        self.assertEqual(len(mesh.triangles), 0)
        self.same_bytes(mesh, "quads.vtk", MODELS / "brickhole.step", "--size", 0.7, "--elements", "quad", "--quality",
                        "best")

    def test_second_order(self):
        mesh = af2.mesh(MODELS / "cylinder.step", size=1, order=2)
        self.same_bytes(mesh, "second.msh", MODELS / "cylinder.step", "--size", 1, "--order", 2)

    def test_changed_models(self):
        bolt, cylinder, die = MODELS / "bolt_on_plate.brep", MODELS / "cylinder.step", MODELS / "die.step"
        self.same_bytes(af2.mesh(bolt, size=0.6, imprint=True), "bolt.msh", bolt, "--size", 0.6, "--imprint")
        self.same_bytes(af2.mesh(cylinder, size=1, heal=1e-4), "healed.vtu", cylinder, "--size", 1, "--heal",
                        "--heal-tolerance", 1e-4)
        self.same_bytes(af2.mesh(die, size=0.8, merge=True), "merged.vtu", die, "--size", 0.8, "--merge")
        self.same_bytes(af2.mesh(cylinder, chord=0.05, fewest=True), "few.stl", cylinder, "--chord", 0.05, "--fewest")

    def test_boundary_points_and_curves(self):
        brick = MODELS / "brickhole.step"
        (self.folder / "b.json").write_text('{"edges": {"3": []}}')
        mesh = af2.mesh(brick, size=1, boundary={3: np.empty((0, 3))})
        self.same_bytes(mesh, "divided.vtu", brick, "--size", 1, "--boundary", "b.json")
        plate = MODELS / "plate.poly"
        (self.folder / "p.json").write_text('{"points": [[0.5, 0.5, 0]], "curves": [[[0.2, 0.2], [0.8, 0.3]]]}')
        mesh = af2.mesh(plate, size=0.5, points=[(0.5, 0.5)], curves=[[(0.2, 0.2), (0.8, 0.3)]])
        self.same_bytes(mesh, "inside.vtu", plate, "--size", 0.5, "--points", "p.json")

    def test_layers_periodic_and_charts(self):
        plate, brick, cylinder = MODELS / "plate.poly", MODELS / "brickhole.step", MODELS / "cylinder.step"
        mesh = af2.mesh(plate, size=0.5, layers=af2.Layers(0.02, 1.3, 6, faces=1))
        self.same_bytes(mesh, "layers.vtu", plate, "--size", 0.5, "--layers", "@1=0.02,1.3,6")
        self.same_bytes(af2.mesh(brick, size=1, periodic="z"), "periodic.msh", brick, "--size", 1, "--periodic", "z")
        self.same_bytes(af2.mesh(cylinder, size=1, chart="mean-normal"), "charts.vtu", cylinder, "--size", 1, "--chart",
                        "mean-normal")

    def test_rules_and_raw_fronts(self):
        cylinder = MODELS / "cylinder.step"
        self.same_bytes(af2.mesh(cylinder, size=1, rules="tri/classic", optimize=False), "raw.vtu", cylinder, "--size", 1,
                        "-r", "tri/classic", "--no-optimize")
        text = (MODELS.parent.parent / "rules/tri/classic.af2").read_text()
        (self.folder / "own.af2").write_text(text)
        self.same_bytes(af2.mesh(cylinder, size=1, rules=text), "own.vtk", cylinder, "--size", 1, "-r", "own.af2")

    def test_options_of_files(self):
        mesh = af2.mesh(MODELS / "cylinder.step", size=1)
        request = (MODELS / "cylinder.step", "--size", 1, "-q")
        self.program("mesh", *request, "--edges", "--groups", "solids", "--unit", "inch", "-o", "p.msh")
        mesh.write(self.folder / "m.msh", edges=True, groups="solids", unit="inch")
        self.program("mesh", *request, "--compress", "--scale", 3, "-o", "p.vtu")
        mesh.write(self.folder / "m.vtu", compress=True, scale=3)
        for extension in ("msh", "vtu"):
            self.assertEqual((self.folder / f"m.{extension}").read_bytes(), (self.folder / f"p.{extension}").read_bytes())

    def test_surfaces_of_triangles(self):
        stl = self.folder / "brick.stl"
        af2.mesh(MODELS / "brickhole.step", size=1).write(stl)
        self.same_bytes(af2.mesh(stl, size=2, feature_angle=30), "again.vtu", stl, "--size", 2, "--feature-angle", 30)

    def test_threads_do_not_change_the_mesh(self):
        meshes = {af2.mesh(MODELS / "die.step", size=0.5, threads=n).fingerprint for n in (1, 2, 5)}
        self.assertEqual(len(meshes), 1)


if __name__ == "__main__":
    unittest.main()
