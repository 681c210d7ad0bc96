"""Quadrilaterals in awkward domains: no crash and no inverted element; triangles that remain are reported.

usage: awkward_quads.py AF2 SOURCES
"""
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile


def divided(corners, size):
    sides = list(zip(corners, corners[1:] + corners[:1]))
    counts = [max(1, round(math.dist(a, b) / size)) for a, b in sides]
    if sum(counts) % 2:
        counts[counts.index(max(counts))] += 1
    return [(a[0] + k / n * (b[0] - a[0]), a[1] + k / n * (b[1] - a[1]))
            for (a, b), n in zip(sides, counts) for k in range(n)]


def uneven_circle(seed, parity):
    """Neighbours whose lengths differ by up to ten times."""
    numbers, angles, angle = random.Random(seed), [], 0
    while angle < 2 * math.pi:
        angles.append(angle)
        angle += .1 * 10 ** numbers.uniform(-.5, .5)
    angles = angles if len(angles) % 2 == parity else angles[:-1]
    return [(math.cos(a), math.sin(a)) for a in angles]


def domains():
    """Name, loops, free vertices, and lines inside that are loops of two edges."""
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    for width in (.1, .02, .001):
        half = width / 2
        yield f"hairpin {width}", [divided([(0, 0), (1, 0), (1, 1), (.5 + half, 1), (.5 + half, .3),
                                            (.5 - half, .3), (.5 - half, 1), (0, 1)], .1)], [], []
        yield f"strip {width}", [divided([(0, 0), (1, 0), (1, width), (0, width)], .1)], [], []
        for depth in (.3, -.3):
            yield f"dent {width} {depth}", [divided([(0, 0), (.5 - half, 0), (.5, depth), (.5 + half, 0),
                                                     (1, 0), (1, 1), (0, 1)], .1)], [], []
    for degrees in (5, 10, 20, 40):
        apex = math.radians(degrees)
        yield f"corner {degrees}", [divided([(0, 0), (1, 0), (math.cos(apex), math.sin(apex))], .1)], [], []
    for seed in range(3):
        yield f"uneven {seed}", [uneven_circle(seed, 0)], [], []
        yield f"uneven, odd {seed}", [uneven_circle(seed, 1)], [], []
    side = [(1, k / 100) for k in range(100)]
    yield "fine side", [divided([(0, 0), (1, 0)], .1)[:10] + side + divided([(1, 1), (0, 1), (0, 0)], .1)[:20]], [], []
    numbers = random.Random(5)
    for count in (1, 30, 200):
        yield f"free {count}", [divided(square, .1)], [(numbers.uniform(.02, .98), numbers.uniform(.02, .98))
                                                       for _ in range(count)], []
    yield "free near the boundary", [divided(square, .1)], [(.05, .004), (.5, .001)], []
    yield "two edges", [divided(square, .1)], [], [(.4, .5), (.6, .5)]
    yield "flat", [[(0, 0), (1, 0), (2, 0), (1, 1)]], [], []
    yield "dart", [[(0, 0), (2, 0), (.3, .3), (0, 2)]], [], []


def write_poly(path, loops, free, line):
    points, segments = [], []
    for loop in loops:
        first = len(points)
        points += loop
        segments += [(first + i, first + (i + 1) % len(loop)) for i in range(len(loop))]
    segments += [(len(points), len(points) + 1)] if line else []
    points += line + free
    lines = [f"{len(points)} 2 0 0"] + [f"{i} {x!r} {y!r}" for i, (x, y) in enumerate(points)]
    lines += [f"{len(segments)} 0"] + [f"{i} {a} {b}" for i, (a, b) in enumerate(segments)] + ["0"]
    path.write_text("\n".join(lines) + "\n")


def faults(af2, name, domain, rules):
    mesh = domain.with_suffix(".vtu")
    mesh.unlink(missing_ok=True)
    command = [af2, "mesh", domain, "--size", ".1", "--keep-boundary", "--elements", "quad", "-r", rules, "-o", mesh, "-q"]
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode not in (0, 3) or not mesh.exists():
        return [f"exit code {run.returncode}: {run.stderr}"]
    found = json.loads(subprocess.run([af2, "quality", mesh, "--format", "json"], capture_output=True,
                                      text=True, check=True).stdout)
    wrong = [f"{found['inverted']} inverted elements"] if found["inverted"] else []
    if (found["triangles"] > 0) != ("triangles remain" in run.stderr):
        wrong.append(f"{found['triangles']} triangles, but it says: {run.stderr}")
    if ("odd" in name) != ("edges: divide the one from" in run.stderr):
        wrong.append(f"the loop is not reported as it is: {run.stderr}")
    return wrong


def main():
    af2 = sys.argv[1]
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "awkward.poly"
        for name, loops, free, line in domains():
            write_poly(path, loops, free, line)
            for rules in ("quad/classic", "quad/rows"):
                for fault in faults(af2, name, path, rules):
                    print(f"{name}, {rules}: {fault}")
                    failures += 1
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
