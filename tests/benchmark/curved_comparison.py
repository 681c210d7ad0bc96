#!/usr/bin/python3
"""Compares finished meshes of AF2, Gmsh and Netgen on CAD models with curved faces.

    curved_comparison.py --af2 build/cli/af2 [--netgen BUILD/tests/benchmark/netgen_driver] \
        [--curvature 12] [--output docs/benchmarks.md] MODEL|FOLDER...

All are asked for the same size, a fortieth of the model's diagonal, and the same number of elements
around a full turn; all else is what the programs do by default. Models count on which all deliver a
mesh. For each: how many triangles, their quality, how many have an angle below 15 degrees, and how
far their centroids lie from the CAD surface (the mean over the area and what 99 % of it keep, in
thousandths of the size), which Gmsh's geometry module tells for all of them. Of a mesh of more than
10,000 triangles so many are drawn for that, each as likely as its share of the area.
Needs Debian's python3-gmsh and python3-numpy; without --netgen, AF2 and Gmsh alone are compared.
"""

import argparse
import multiprocessing
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

import gmsh
import numpy as np

SUFFIXES = {".step", ".stp", ".iges", ".igs", ".brep"}
SIZES_PER_DIAGONAL = 40
BAD_ANGLE = 15  # degrees
MOST_SAMPLES = 10_000  # centroids of a mesh that are held against the surface
AF2, GMSH, NETGEN = "AF2", "Gmsh", "Netgen"
BEGIN, END = "<!-- curved models: begin -->", "<!-- curved models: end -->"


def options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("models", nargs="+", type=Path, help="models, or folders with models")
    parser.add_argument("--af2", required=True)
    parser.add_argument("--netgen", help="the program netgen_driver, if it was built, or a Python with the module netgen")
    parser.add_argument("--gmsh", help="the program gmsh of any build; default: Debian's Python module")
    parser.add_argument("--curvature", type=float, default=12, help="elements around a full turn")
    parser.add_argument("--limit", type=float, default=60, help="seconds for one mesh")
    parser.add_argument("--output", type=Path, help="file whose table is replaced; else printed")
    return parser.parse_args()


class Shape:
    """A model as Gmsh reads it, to measure distances."""

    def __init__(self, path: Path):
        gmsh.clear()
        gmsh.model.occ.importShapes(str(path))
        gmsh.model.occ.synchronize()
        self.faces = [tag for _, tag in gmsh.model.getEntities(2)]
        self.boxes = {tag: np.array(gmsh.model.getBoundingBox(2, tag)) for tag in self.faces}
        box = np.array(gmsh.model.getBoundingBox(-1, -1))
        self.diagonal = float(np.linalg.norm(box[3:] - box[:3]))
        self.is_curved = any(gmsh.model.getType(2, tag) != "Plane" for tag in self.faces)

    def distances(self, points: np.ndarray, reach: float) -> np.ndarray:
        """From the nearest face whose box is within reach; infinite where there is none."""
        least = np.full(len(points), np.inf)
        for tag, box in self.boxes.items():
            near = np.flatnonzero(np.all((points >= box[:3] - reach) & (points <= box[3:] + reach), axis=1))
            if not len(near):
                continue
            closest, _ = gmsh.model.getClosestPoint(2, tag, points[near].ravel())
            distance = np.linalg.norm(np.reshape(closest, (-1, 3)) - points[near], axis=1)
            least[near] = np.minimum(least[near], distance)
        return least


def models_of(given: list) -> list:
    found = []
    for path in given:
        found += [path] if path.is_file() else sorted(p for p in path.rglob("*") if p.suffix in SUFFIXES)
    return found


def commands(chosen: argparse.Namespace, model: Path, size: float, mesh: Path) -> dict:
    turn = str(chosen.curvature)
    made = {
        AF2: [chosen.af2, "mesh", str(model), "-q", "-j", "1", "-s", repr(size), "--curvature", turn, "-o", str(mesh)],
        GMSH: ["/usr/bin/python3", str(Path(__file__).with_name("gmsh_driver.py")), str(model), repr(size),
               "--curvature", turn, "--obj", str(mesh), *(["--program", chosen.gmsh] if chosen.gmsh else [])],
    }
    if chosen.netgen and "python" in Path(chosen.netgen).name:
        made[NETGEN] = [chosen.netgen, str(Path(__file__).with_name("netgen_file.py")), str(model), repr(size), str(mesh),
                        "--curvature", turn]
    elif chosen.netgen:
        made[NETGEN] = [chosen.netgen, str(model), repr(size), turn, str(mesh)]
    return made


def read_obj(path: Path) -> tuple:
    points, corners = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words and words[0] == "v":
            points.append([float(word) for word in words[1:4]])
        elif words and words[0] == "f":
            corners.append([int(word.split("/")[0]) - 1 for word in words[1:4]])
    return np.array(points), np.array(corners, dtype=int)


def measure(shape: Shape, path: Path, size: float) -> dict:
    points, corners = read_obj(path)
    p = points[corners]
    sides = np.roll(p, -1, axis=1) - p
    squares = (sides ** 2).sum(axis=2)
    area = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1) / 2
    quality = np.sort(4 * np.sqrt(3) * area / squares.sum(axis=1))
    # At each corner, between the side that leaves it and the one that comes.
    cosine = -(sides * np.roll(sides, 1, axis=1)).sum(axis=2) / np.sqrt(squares * np.roll(squares, 1, axis=1))
    angles = np.degrees(np.arccos(np.clip(cosine, -1, 1))).min(axis=1)
    sample, weight = drawn(area)
    distance = shape.distances(p.mean(axis=1)[sample], size) / size
    known = np.isfinite(distance)
    distance, weight = distance[known], weight[known]
    return {"triangles": len(p), "mean": quality.mean(), "p1": quality[len(quality) // 100], "min": quality[0],
            "bad": 1e3 * float((angles < BAD_ANGLE).mean()),
            "deviation": 1e3 * float(np.average(distance, weights=weight)),
            "deviation99": 1e3 * weighted_percentile(distance, weight, 0.99)}


def drawn(area: np.ndarray) -> tuple:
    """Elements that stand for all, and the area that each stands for: all of a small mesh. Of a larger one the area is
    cut into equal parts, in the order of the file, which runs along the surface, and a place is drawn in each part; the
    same ones on every run."""
    if len(area) <= MOST_SAMPLES:
        return np.arange(len(area)), area
    ends = np.cumsum(area)
    places = (np.arange(MOST_SAMPLES) + np.random.default_rng(1).random(MOST_SAMPLES)) / MOST_SAMPLES * ends[-1]
    elements, times = np.unique(np.minimum(np.searchsorted(ends, places), len(area) - 1), return_counts=True)
    return elements, times.astype(float)


def weighted_percentile(values: np.ndarray, weights: np.ndarray, part: float) -> float:
    order = np.argsort(values)
    sums = np.cumsum(weights[order])
    return float(values[order][np.searchsorted(sums, part * sums[-1])])


def compare(chosen: argparse.Namespace, model: Path) -> dict | None:
    """Figures by program; None if the model is not for this or one of the programs fails."""
    try:
        shape = Shape(model)
    except Exception:  # Gmsh's module knows no other class of errors
        return None
    if not shape.is_curved:
        return None
    size, found = shape.diagonal / SIZES_PER_DIAGONAL, {}
    with tempfile.TemporaryDirectory() as folder:
        mesh = Path(folder) / "mesh.obj"
        for name, command in commands(chosen, model, size, mesh).items():
            mesh.unlink(missing_ok=True)
            try:
                done = subprocess.run(command, capture_output=True, timeout=chosen.limit, check=False)
            except subprocess.TimeoutExpired:
                return None
            if done.returncode or not mesh.exists():
                return None
            found[name] = measure(shape, mesh, size)
    return found


def compare_apart(chosen: argparse.Namespace, model: Path) -> dict | None:
    """The same in a process of its own: Gmsh's module can crash on a damaged model."""
    def work():
        gmsh.initialize()
        gmsh.option.setNumber("General.Terminal", 0)
        sender.send(compare(chosen, model))

    receiver, sender = multiprocessing.Pipe(duplex=False)
    process = multiprocessing.get_context("fork").Process(target=work)
    process.start()
    sender.close()  # so that the end of the process ends the waiting
    try:
        found = receiver.recv() if receiver.poll(5 * chosen.limit) else None
    except EOFError:
        found = None
    process.kill()
    process.join()
    return found


COLUMNS = ("triangles", "mean", "p1", "min", "bad", "deviation", "deviation99")
FORMATS = ("{:,.0f}", "{:.4f}", "{:.3f}", "{:.3f}", "{:.1f}", "{:.2f}", "{:.2f}")


def line(model: str, program: str, figures: dict) -> str:
    numbers = [form.format(figures[column]) for column, form in zip(COLUMNS, FORMATS)]
    return f"| {model} | {program} | " + " | ".join(numbers) + " |"


def table(results: dict) -> list:
    lines = ["| model | program | triangles | mean | 1st percentile | min | bad, per mille | "
             "deviation, mean | deviation, 99 % |", "|---|---|" + "---:|" * len(COLUMNS)]
    for program in next(iter(results.values())):
        figures = {c: np.median([found[program][c] for found in results.values()]) for c in COLUMNS}
        lines.append(line(f"median of {len(results)}", program, figures))
    for model, found in results.items():
        lines += [line(model, program, figures) for program, figures in found.items()]
    return lines


def share_text(results: dict) -> list:
    """On how many models AF2 is at least as good as each of the others."""
    lines = []
    for peer in [name for name in next(iter(results.values())) if name != AF2]:
        words = []
        for column, sign in (("mean", 1), ("p1", 1), ("bad", -1), ("deviation", -1), ("deviation99", -1)):
            slack = 1e-3 if sign > 0 else 1e-2
            count = sum(sign * (found[AF2][column] - found[peer][column]) >= -slack for found in results.values())
            words.append(f"{column} {count}")
        lines.append(f"Of {len(results)} models, AF2 is not below {peer} in: {', '.join(words)}.")
    return lines


def write(lines: list, output: Path | None) -> None:
    text = "\n".join(lines) + "\n"
    if output is None:
        print(text, end="")
        return
    before, rest = output.read_text().split(BEGIN, 1)
    output.write_text(f"{before}{BEGIN}\n{text}{END}{rest.split(END, 1)[1]}")


def main() -> int:
    chosen = options()
    results = {}
    for model in models_of(chosen.models):
        if model.stem in results:  # in another format
            continue
        found = compare_apart(chosen, model)
        if found:
            results[model.stem] = found
            for program, figures in found.items():
                print(line(model.stem, program, figures), file=sys.stderr)
        else:
            print(f"{model.stem}: not compared", file=sys.stderr)
    if not results:
        sys.exit("no model with curved faces on which all programs deliver a mesh")
    command = shlex.join(["tests/benchmark/curved_comparison.py", *sys.argv[1:]])
    write(["```", command, "```", ""] + share_text(results) + [""] + table(results), chosen.output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
