"""What the tests of the Python package share: the program to compare with, the models, a folder that goes away."""

import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ.get("AF2_PROGRAM", "")
SOURCE = pathlib.Path(os.environ.get("AF2_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
MODELS = SOURCE / "examples" / "models"


class Case(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def program(self, *arguments, code=0):
        """Runs the program in the folder of the test; returns what it printed."""
        if not PROGRAM:
            self.skipTest("AF2_PROGRAM does not name the program af2")
        done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stdout + done.stderr

    def same_bytes(self, mesh, name, *arguments):
        """The mesh has the bytes that the program writes for these arguments; `name` is that of the file."""
        self.program("mesh", *arguments, "-q", "-o", "program-" + name)
        mesh.write(self.folder / name)
        self.assertEqual((self.folder / name).read_bytes(), (self.folder / ("program-" + name)).read_bytes(), name)
