"""Quadrilateral meshes of Gmsh and Netgen for quads.py, each in a process of its own.

Unless quads.py is told otherwise, Gmsh is Debian's package `gmsh`, and Netgen is `python3-netgen`; neither is needed for
anything else.
"""
import math
import pathlib
import shutil
import subprocess
import sys

LIMIT = 120  # seconds
FRONTAL, PACKING = 6, 9  # 8, made for quadrilaterals, crashes together with full-quad in 4.8
BLOSSOM, FULL_QUAD_BLOSSOM = 1, 3
places = {"gmsh": "gmsh",  # any build of the program
          "netgen": "/usr/bin/python3"}  # a Python with the module netgen: Debian's, for which python3-netgen is made


class Gmsh:
    reads_models = True

    def __init__(self, title, algorithm, recombination, is_halved=False):
        self.title, self.algorithm, self.recombination = title, algorithm, recombination
        self.is_halved = is_halved  # it wants an even number of segments on each line

    def missing(self):
        return None if shutil.which(places["gmsh"]) else "gmsh is not installed (Debian: gmsh)"

    def boundary(self):
        if self.is_halved:
            return "every other vertex of the boundary is given; Gmsh halves the lines between them"
        return "the boundary is given"

    def settings(self, size):
        return [f"Mesh.Algorithm = {self.algorithm};", "Mesh.RecombineAll = 1;",
                f"Mesh.RecombinationAlgorithm = {self.recombination};", f"Mesh.MeshSizeMax = {size};",
                "Mesh.MeshSizeMin = 0;", "Mesh.MshFileVersion = 2.2;", "Mesh.SaveAll = 1;",
                "General.NumThreads = 1;"]

    def mesh_domain(self, domain, size, folder):
        """The file with the mesh, or what went wrong."""
        lines, first, loops = [], 1, []
        scale = 2 if self.is_halved else 1
        for loop in domain.loops:
            points = loop[::scale]
            n = len(points)
            lengths = [math.dist(p, q) for p, q in zip(points, points[1:] + points[:1])]
            for i, (x, y) in enumerate(points):
                at = .5 * (lengths[i] + lengths[i - 1]) / scale
                lines.append(f"Point({first + i}) = {{{x!r}, {y!r}, 0, {at!r}}};")
            for i in range(n):
                lines.append(f"Line({first + i}) = {{{first + i}, {first + (i + 1) % n}}};")
            lines.append(f"Curve Loop({first}) = {{{first}:{first + n - 1}}};")
            loops.append(str(first))
            first += n
        lines.append(f"Transfinite Curve {{1:{first - 1}}} = {scale + 1};")
        lines.append(f"Plane Surface(1) = {{{', '.join(loops)}}};")
        largest = 2 * size if domain.sizes else size
        return self.run(lines + self.settings(largest), folder)

    def mesh_model(self, model, size, folder):
        return self.run([f'Merge "{model}";'] + self.settings(size), folder)

    def run(self, lines, folder):
        script, mesh = folder / "peer.geo", folder / "peer.msh"
        mesh.unlink(missing_ok=True)
        script.write_text("\n".join(lines) + "\n")
        try:
            run = subprocess.run([places["gmsh"], "-2", str(script), "-o", str(mesh)], capture_output=True, text=True,
                                 timeout=LIMIT)
        except subprocess.TimeoutExpired:
            return None, f"longer than {LIMIT} s"
        return (mesh, None) if mesh.exists() else (None, f"exit code {run.returncode}")


class Netgen:
    title, reads_models = "Netgen", False  # Debian's package has no part for CAD files

    def missing(self):
        found = shutil.which(places["netgen"]) and subprocess.run([places["netgen"], "-c", "import netgen"], capture_output=True)
        return None if found and found.returncode == 0 else "Netgen is not installed (Debian: python3-netgen)"

    def boundary(self):
        return "the boundary is given; Netgen divides long segments beside short ones"

    def mesh_domain(self, domain, size, folder):
        mesh = folder / "peer.obj"
        mesh.unlink(missing_ok=True)
        # Segments that are longer than the largest size are divided.
        longest = max(math.dist(p, q) for loop in domain.loops for p, q in zip(loop, loop[1:] + loop[:1]))
        largest = max(size, 1.0001 * longest)
        run = subprocess.run([places["netgen"], __file__, str(mesh), repr(largest)], input=repr(domain.loops), capture_output=True,
                             text=True)
        return (mesh, None) if mesh.exists() else (None, f"exit code {run.returncode}")


PEERS = [Gmsh("Gmsh, Blossom", FRONTAL, BLOSSOM),
         Gmsh("Gmsh, full-quad", FRONTAL, FULL_QUAD_BLOSSOM, is_halved=True),
         Gmsh("Gmsh, packing", PACKING, BLOSSOM), Netgen()]


def mesh_with_netgen(path, size):
    import ast
    from netgen.geom2d import SplineGeometry
    geometry = SplineGeometry()
    for number, loop in enumerate(ast.literal_eval(sys.stdin.read())):
        points = [geometry.AppendPoint(x, y) for x, y in loop]
        is_outer = number == 0  # all loops run counter-clockwise
        for i, point in enumerate(points):
            geometry.Append(["line", point, points[(i + 1) % len(points)]],
                            leftdomain=int(is_outer), rightdomain=int(not is_outer))
    mesh = geometry.GenerateMesh(maxh=size, quad_dominated=True)
    lines = [f"v {p[0]!r} {p[1]!r} 0" for p in mesh.Points()]
    lines += ["f " + " ".join(str(v.nr) for v in element.vertices) for element in mesh.Elements2D()]
    pathlib.Path(path).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    mesh_with_netgen(sys.argv[1], float(sys.argv[2]))
