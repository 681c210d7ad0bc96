"""Functions of sizes, progress, Ctrl-C, and several threads at once."""

import os
import signal
import subprocess
import sys
import textwrap
import threading
import time
import unittest

import numpy as np

import af2
from support import MODELS, Case

DIE = MODELS / "die.step"


def fine_below(points):
    return np.where(points[:, 2] < 0, 0.3, np.inf)


class SizesFromFunctions(Case):
    def test_elements_follow_the_sizes(self):
        mesh = af2.mesh(MODELS / "cylinder.step", size=1, sizes=lambda p: 0.15 + 0.1 * np.abs(p[:, 2]))
        sides = mesh.points[mesh.triangles]
        lengths = np.linalg.norm(sides - np.roll(sides, 1, axis=1), axis=2).mean(axis=1)
        wanted = np.minimum(1, 0.15 + 0.1 * np.abs(sides[:, :, 2].mean(axis=1)))
        self.assertLess(np.median(np.abs(lengths / wanted - 1)), 0.2)

    def test_is_called_with_many_points_and_the_result_does_not_depend_on_threads(self):
        calls = []

        def sizes(points):
            self.assertEqual((points.ndim, points.shape[1], points.dtype), (2, 3, np.dtype(float)))
            calls.append(len(points))
            return np.full(len(points), 0.7)

        alone = af2.mesh(DIE, size=1, sizes=sizes, threads=1).fingerprint
        self.assertGreater(max(calls), 20)
        self.assertEqual(af2.mesh(DIE, size=1, sizes=sizes, threads=4).fingerprint, alone)
        self.assertEqual(af2.mesh(DIE, size=1, sizes=lambda p: 0.7).fingerprint, alone)  # one number for all

    def test_may_stand_beside_other_sources(self):
        cylinder = MODELS / "cylinder.step"
        near = {"points": [{"at": af2.read(cylinder).parts().edges[0].start, "size": 0.1}]}
        of_points, of_function, of_both = (len(af2.mesh(cylinder, size=3, sizes=sizes).elements)
                                           for sizes in (near, lambda p: 1.5, [lambda p: 1.5, near]))
        self.assertGreater(of_both, 1.1 * max(of_points, of_function))
        with self.assertRaisesRegex(af2.InputError, "a list of one function"):
            af2.mesh(cylinder, size=1, sizes=[near, near])

    def test_points_may_be_kept(self):
        kept = []
        af2.mesh(MODELS / "cylinder.step", size=1, sizes=lambda p: kept.append(p) or np.full(len(p), 0.9))
        everything = np.concatenate(kept)
        self.assertTrue(np.all(np.isfinite(everything)))
        self.assertLess(np.abs(everything).max(), 100)

    def test_errors_of_the_function_are_raised(self):
        def broken(points):
            raise LookupError("no size in the table")

        for threads in (1, 3):
            with self.assertRaisesRegex(LookupError, "no size in the table"):
                af2.mesh(DIE, size=1, sizes=broken, threads=threads)

    def test_wrong_sizes_are_refused(self):
        wrong = {"one number for each": lambda p: np.ones(len(p) + 1), "one number for each of": lambda p: np.ones((len(p), 2)),
                 "must return numbers": lambda p: None and "" or "small"}
        for message, sizes in wrong.items():
            with self.assertRaisesRegex((ValueError, TypeError), message):
                af2.mesh(DIE, size=1, sizes=sizes)
        for value in (0, -1, np.nan):
            with self.assertRaises(af2.InputError):
                af2.mesh(DIE, size=1, sizes=lambda p: np.full(len(p), value))


class Progress(Case):
    def test_is_reported(self):
        seen = []
        mesh = af2.mesh(DIE, size=0.3, progress=lambda p: seen.append((p.fraction, p.faces_done, p.faces)))
        self.assertGreater(len(seen), 3)
        fractions = [fraction for fraction, _, _ in seen]
        self.assertEqual(fractions, sorted(fractions))
        self.assertEqual(seen[-1][2], len(mesh.faces))

    def test_an_exception_stops_the_mesher(self):
        class Enough(Exception):
            pass

        def stop(progress):
            raise Enough

        begin = time.monotonic()
        with self.assertRaises(Enough):
            af2.mesh(DIE, size=0.02, progress=stop)
        self.assertLess(time.monotonic() - begin, 20)


class SeveralThreads(Case):
    def test_mesh_at_once(self):
        jobs = [("die.step", 0.7), ("cylinder.step", 0.4), ("brickhole.step", 0.5), ("plate.poly", 0.2)] * 2
        alone = {job: af2.mesh(MODELS / job[0], size=job[1], sizes=lambda p: np.inf).fingerprint for job in set(jobs)}
        made = [None] * len(jobs)

        def work(i):
            made[i] = af2.mesh(MODELS / jobs[i][0], size=jobs[i][1], sizes=lambda p: np.inf).fingerprint

        threads = [threading.Thread(target=work, args=(i,)) for i in range(len(jobs))]
        [thread.start() for thread in threads]
        [thread.join() for thread in threads]
        self.assertEqual(made, [alone[job] for job in jobs])

    def test_share_a_model_and_rules(self):
        model, rules = af2.read(DIE), af2.load_rules("tri/classic")
        made = []
        threads = [threading.Thread(target=lambda: made.append(af2.mesh(model, 0.8, rules=rules).fingerprint))
                   for _ in range(4)]
        [thread.start() for thread in threads]
        [thread.join() for thread in threads]
        self.assertEqual(len(made), 4)
        self.assertEqual(len(set(made)), 1)

    def test_python_goes_on_meanwhile(self):
        ticks = []
        done = threading.Event()

        def tick():
            while not done.is_set():
                ticks.append(None)
                time.sleep(0.002)

        ticker = threading.Thread(target=tick)
        ticker.start()
        begin = time.monotonic()
        af2.mesh(DIE, size=0.12, threads=1)
        spent = time.monotonic() - begin
        done.set()
        ticker.join()
        self.assertGreater(len(ticks), 20 * spent)  # without the GIL released it would be one or two


class Interrupt(Case):
    CODE = textwrap.dedent("""
        import sys, time, af2
        model = af2.read(sys.argv[1])
        print("go", flush=True)
        try:
            af2.mesh(model, size=0.01, {more})
        except KeyboardInterrupt:
            print("interrupted", flush=True)
            print(af2.mesh(model, size=1).complete)
    """)

    def interrupt(self, more=""):
        child = subprocess.Popen([sys.executable, "-c", self.CODE.format(more=more), str(DIE)], stdout=subprocess.PIPE,
                                 text=True)
        self.addCleanup(child.stdout.close)
        self.addCleanup(child.wait)
        self.addCleanup(child.kill)
        self.assertEqual(child.stdout.readline(), "go\n")
        time.sleep(1)
        begin = time.monotonic()
        os.kill(child.pid, signal.SIGINT)
        self.assertEqual(child.stdout.readline(), "interrupted\n")
        self.assertLess(time.monotonic() - begin, 10)
        self.assertEqual(child.stdout.readline(), "True\n")  # nothing is left in a bad state
        self.assertEqual(child.wait(), 0)

    def test_stops_the_mesher(self):
        self.interrupt()

    def test_stops_it_between_calls_of_functions(self):
        self.interrupt("sizes=lambda p: 0.01 + 0 * p[:, 0]")


if __name__ == "__main__":
    unittest.main()
