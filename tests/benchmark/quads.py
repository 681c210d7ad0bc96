#!/usr/bin/env python3
"""Meshes of quadrilaterals on planar domains with given, even boundaries, and on models.

usage: quads.py AF2 MODELS [RULES...]

Prints a table in Markdown: the number of elements, the share of irregular vertices, and scaled Jacobians, for
each of several ways to finish the mesh. docs/quads.md shows it.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import time

WAYS = ["--quality fast", "", "--elements quad", "--elements quad --quality best"]


def divided(corners, size):
    """A polygon whose sides are divided, with an even number of segments in all."""
    sides = list(zip(corners, corners[1:] + corners[:1]))
    counts = [max(1, round(math.dist(a, b) / size)) for a, b in sides]
    if sum(counts) % 2:
        counts[counts.index(max(counts))] += 1
    return [(a[0] + k / n * (b[0] - a[0]), a[1] + k / n * (b[1] - a[1]))
            for (a, b), n in zip(sides, counts) for k in range(n)]


def arc(radius, begin, end, size, centre=(0, 0), segments=0):
    n = segments or max(1, round(radius * (end - begin) / size))
    angles = [begin + (end - begin) * k / n for k in range(n)]
    return [(centre[0] + radius * math.cos(a), centre[1] + radius * math.sin(a)) for a in angles]


def circle(x, y, radius, size):
    n = max(6, 2 * round(math.pi * radius / size))
    return arc(radius, 0, 2 * math.pi, size, (x, y), n)


def gear(size):
    pitch, outline = 2 * math.pi / 12, []
    at = lambda radius, angle: (radius * math.cos(angle), radius * math.sin(angle))
    for tooth in range(12):
        begin = tooth * pitch
        root, rise, tip, fall = (begin + share * pitch for share in (.34, .46, .88, 1))
        outline += arc(.38, begin, root, size)
        outline += flank(at(.38, root), at(.5, rise), size)
        outline += arc(.5, rise, tip, size)
        outline += flank(at(.5, tip), at(.38, fall), size)
    return outline


def flank(a, b, size):
    n = max(1, round(math.dist(a, b) / size))
    return [(a[0] + k / n * (b[0] - a[0]), a[1] + k / n * (b[1] - a[1])) for k in range(n)]


def airfoil(size):
    """NACA 0012, of length 1."""
    half = lambda x: .6 * (.2969 * math.sqrt(x) - .126 * x - .3516 * x**2 + .2843 * x**3 - .1036 * x**4)
    n = max(8, round(1.02 / size))
    upper = [(x, half(x)) for x in (.5 * (1 - math.cos(math.pi * k / n)) for k in range(n + 1))]
    return upper[::-1] + [(x, -y) for x, y in upper[1:-1]]


def domains(size):
    square = divided([(0, 0), (1, 0), (1, 1), (0, 1)], size)
    box = divided([(-.5, -.75), (1.5, -.75), (1.5, .75), (-.5, .75)], size)
    corner = divided([(0, 0), (1, 0), (1, .5), (.5, .5), (.5, 1), (0, 1)], size)
    return {"square with hole": ([square, circle(.5, .5, .2, size)], [(.5, .5)]),
            "gear": ([gear(size), circle(0, 0, .12, size)], [(0, 0)]),
            "disc": ([circle(0, 0, .5, size)], []),
            "eccentric annulus": ([circle(0, 0, .5, size), circle(.15, 0, .2, size)], [(.15, 0)]),
            "airfoil in a box": ([box, airfoil(size)], [(.5, 0)]),
            "L-shape": ([corner], [])}


def write_poly(path, loops, holes):
    points, segments = [], []
    for loop in loops:
        first = len(points) + 1
        points += loop
        segments += [(first + i, first + (i + 1) % len(loop)) for i in range(len(loop))]
    lines = [f"{len(points)} 2 0 0"] + [f"{i} {x!r} {y!r}" for i, (x, y) in enumerate(points, 1)]
    lines += [f"{len(segments)} 0"] + [f"{i} {a} {b}" for i, (a, b) in enumerate(segments, 1)]
    lines += [str(len(holes))] + [f"{i} {x} {y}" for i, (x, y) in enumerate(holes, 1)]
    path.write_text("\n".join(lines) + "\n")


def cell(af2, model, size, options, folder):
    mesh = folder / "mesh.obj"
    mesh.unlink(missing_ok=True)
    began = time.monotonic()
    command = [af2, "mesh", model, "--size", str(size), "-o", mesh, "-q", "-j", "1"] + options
    code = subprocess.run(command, capture_output=True).returncode
    seconds = time.monotonic() - began
    if not mesh.exists():
        return f"exit code {code}"
    found = json.loads(subprocess.run([af2, "quality", mesh, "--format", "json"], capture_output=True,
                                      check=True).stdout)
    inside, jacobian = found["irregular"]["inside"], found["scaled_jacobian"]["quads"]
    share = 100 * inside["irregular"] / max(1, inside["vertices"])
    triangles = f", {found['triangles']} tri" if found["triangles"] else ""
    return (f"{share:.1f} % / {jacobian['min']:.2f} / {jacobian['mean']:.3f} "
            f"({found['quads']}{triangles}; {seconds:.2f} s)")


def main():
    af2, models = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    rule_sets = sys.argv[3:] or ["quad/classic", "quad/rows"]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        jobs = []
        for size in (.05, .0125):
            for title, (loops, holes) in domains(size).items():
                path = folder / f"{title} {size}.poly"
                write_poly(path, loops, holes)
                jobs.append((f"{title}, {size}", path, size, ["--keep-boundary"]))
        for title in ("cylinder", "die"):
            jobs.append((f"{title}, 0.5", models / f"{title}.step", .5, []))
        print("| domain, size | set | " + " | ".join(f"`{way}`" if way else "default" for way in WAYS) + " |\n|---" + "|---" * (1 + len(WAYS)) + "|")
        for title, path, size, options in jobs:
            for rules in rule_sets:
                cells = [cell(af2, path, size, options + ["-r", rules] + way.split(), folder) for way in WAYS]
                print(f"| {title} | {rules} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
