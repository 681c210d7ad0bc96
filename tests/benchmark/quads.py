#!/usr/bin/env python3
"""Meshes of quadrilaterals on planar domains with given, even boundaries, and on models.

    quads.py AF2 MODELS [RULES ...] [--peers] [--rows] [--random N] [--only DOMAIN ...]

Prints tables in Markdown, which docs/quads.md shows: the share of irregular vertices inside, the minimum and the
mean of the scaled Jacobian, and the numbers of elements, for each of several ways to finish the mesh. Random
domains share a line: their vertices and elements together, the smallest of the minima, and on how many of them
triangles remain. Times are processor times of the whole program. With --peers, another table shows the meshes of Gmsh
and Netgen, if Debian's packages gmsh and python3-netgen are there; with --rows, one shows how the rows along boundaries
look.
"""
import argparse
import dataclasses
import json
import pathlib
import resource
import subprocess
import sys
import tempfile

import quad_domains
import quad_peers

WAYS = ["--quality fast", "", "--elements quad", "--elements quad --quality best"]
SIZES = (.05, .0125)
RANDOM_SIZES = (.05, .025)


@dataclasses.dataclass
class Job:
    """One line of a table: a domain or a model, or several random domains."""
    title: str
    size: float
    inputs: list  # paths, each with the options that it needs
    domains: list = None  # None: a model


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("af2", type=lambda name: pathlib.Path(name).resolve())
    parser.add_argument("models", type=lambda name: pathlib.Path(name).resolve(), help="examples/models")
    parser.add_argument("rules", nargs="*", help="default: quad/classic quad/rows")
    parser.add_argument("--peers", action="store_true", help="also meshes of Gmsh and Netgen")
    parser.add_argument("--gmsh", default=quad_peers.places["gmsh"], metavar="PATH", help="for --peers: the program gmsh")
    parser.add_argument("--netgen", default=quad_peers.places["netgen"], metavar="PATH",
                        help="for --peers: a Python with the module netgen")
    parser.add_argument("--rows", action="store_true", help="also a table of the rows along boundaries")
    parser.add_argument("--random", type=int, default=60, metavar="N", help="the number of random domains")
    parser.add_argument("--only", nargs="+", metavar="DOMAIN", help="only lines whose titles begin like this")
    chosen = parser.parse_args()
    quad_peers.places.update(gmsh=chosen.gmsh, netgen=chosen.netgen)
    chosen.rules = chosen.rules or ["quad/classic", "quad/rows"]
    return chosen


def jobs(models, randoms, folder):
    def job(title, size, domains):
        paths = [folder / f"{title} {i}.poly" for i in range(len(domains))]
        return Job(title, size, [(path, quad_domains.write_poly(path, domain)) for path, domain in zip(paths, domains)],
                   domains)

    for size in SIZES:
        for name, domain in quad_domains.named(size).items():
            yield job(f"{name}, {size}", size, [domain])
    for size in RANDOM_SIZES:
        for is_uneven in (False, True):
            domains = [quad_domains.random_domain(seed, size, is_uneven) for seed in range(randoms)]
            if domains:
                yield job(f"{randoms} random domains, {'uneven' if is_uneven else 'even'} edges, {size}", size, domains)
    for name in ("cylinder", "die"):
        yield Job(f"{name}, 0.5", .5, [(models / f"{name}.step", [])])


class Sum:
    """Measures of one mesh or several."""

    def __init__(self):
        self.irregular = self.inside = self.quads = self.triangles = self.inverted = self.meshes = self.mixed = 0
        self.least, self.jacobians, self.seconds, self.faults = 1, 0, 0, []

    def add(self, af2, mesh, seconds):
        run = subprocess.run([af2, "quality", mesh, "--format", "json"], capture_output=True, text=True)
        if run.returncode != 0:
            self.faults.append(run.stderr.strip().split("error: ")[-1].replace(f"{mesh}:", "line "))
            return
        found = json.loads(run.stdout)
        inside, jacobian = found["irregular"]["inside"], found["scaled_jacobian"]["quads"]
        self.irregular += inside["irregular"]
        self.inside += inside["vertices"]
        self.quads += found["quads"]
        self.triangles += found["triangles"]
        self.inverted += found["inverted"]
        self.mixed += found["triangles"] > 0
        self.meshes += 1
        self.seconds += seconds
        if jacobian:
            self.least = min(self.least, jacobian["min"])
            self.jacobians += found["quads"] * jacobian["mean"]

    def text(self):
        faults = f"{len(self.faults)} failed: {self.faults[0]}" if self.faults else ""
        if self.meshes == 0:
            return faults
        triangles = f", {self.triangles} tri" if self.triangles else ""
        if self.triangles and self.meshes > 1:
            triangles += f" on {self.mixed}"
        inverted = f", {self.inverted} inverted" if self.inverted else ""
        return (f"{100 * self.irregular / max(1, self.inside):.1f} % / {self.least:.2f} / "
                f"{self.jacobians / max(1, self.quads):.3f} ({self.quads}{triangles}{inverted}; {self.seconds:.2f} s)"
                + (f", {faults}" if faults else ""))


def child_seconds():
    """Processor time of all programs that have run so far."""
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime


def run_af2(af2, job, path, options, mesh):
    mesh.unlink(missing_ok=True)
    command = [af2, "mesh", path, "--size", str(job.size), "-o", mesh, "-q", "-j", "1"] + options
    return subprocess.run(command, capture_output=True).returncode


def af2_cell(af2, job, options, folder):
    total, mesh = Sum(), folder / "mesh.obj"
    for path, own in job.inputs:
        began = child_seconds()
        code = run_af2(af2, job, path, own + options, mesh)
        seconds = child_seconds() - began
        if mesh.exists():
            total.add(af2, mesh, seconds)
        else:
            total.faults.append(f"exit code {code}")
    return total.text()


def peer_cell(af2, job, peer, folder):
    if not job.domains and not peer.reads_models:
        return "-"
    total = Sum()
    for i, (path, _) in enumerate(job.inputs):
        began = child_seconds()
        if job.domains:
            mesh, fault = peer.mesh_domain(job.domains[i], job.size, folder)
        else:
            mesh, fault = peer.mesh_model(path, job.size, folder)
        seconds = child_seconds() - began
        if mesh:
            total.add(af2, mesh, seconds)
        else:
            total.faults.append(fault)
    return total.text()


def head(columns):
    print("| " + " | ".join(columns) + " |\n|" + "---|" * len(columns))


def main():
    chosen = arguments()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        lines = [job for job in jobs(chosen.models, chosen.random, folder)
                 if not chosen.only or job.title.startswith(tuple(chosen.only))]
        head(["domain, size", "set"] + [f"`{way}`" if way else "default" for way in WAYS])
        for job in lines:
            for rules in chosen.rules:
                cells = [af2_cell(chosen.af2, job, ["-r", rules] + way.split(), folder) for way in WAYS]
                print(f"| {job.title} | {rules} | " + " | ".join(cells) + " |", flush=True)
        if chosen.rows:
            print_rows(chosen.af2, lines, chosen.rules, folder)
        if chosen.peers:
            print_peers(chosen.af2, lines, folder)


def print_rows(af2, lines, sets, folder):
    """Of single planar domains: irregular vertices by their distance from the boundary, and how edges run there."""
    print()
    head(["domain, size", "set", "irregular vertices 1, 2, 3 edges from the boundary",
          "angle between edges and the normal of the boundary, mean / 95 %", "edge length over size, mean (5 % to 95 %; extremes)"])
    mesh = folder / "mesh.obj"
    for job in lines:
        if not job.domains or len(job.domains) > 1:
            continue
        for rules in sets:
            path, own = job.inputs[0]
            run_af2(af2, job, path, own + ["-r", rules, "--elements", "quad"], mesh)
            run = subprocess.run([af2, "quality", mesh, "--size", str(job.size), "--format", "json"],
                                 capture_output=True, text=True, check=True)
            found = json.loads(run.stdout)
            rings = [str(ring["irregular"]) for ring in found["irregular"]["rings"][1:4]]
            spokes, lengths = found["spokes"], found["lengths"]
            angles = f"{spokes['mean']:.1f} / {spokes['p95']:.1f}" if spokes else "-"
            print(f"| {job.title} | {rules} | {', '.join(rings)} | {angles} | {lengths['mean']:.2f} "
                  f"({lengths['p5']:.2f} to {lengths['p95']:.2f}; {lengths['min']:.2f} to {lengths['max']:.2f}) |", flush=True)


def print_peers(af2, lines, folder):
    peers = [peer for peer in quad_peers.PEERS if not peer.missing()]
    print()
    for reason in sorted({peer.missing() for peer in quad_peers.PEERS} - {None}):
        print(f"{reason}\n")
    if not peers:
        return
    for peer in peers:
        print(f"* {peer.title}: {peer.boundary()}")
    print("* On models, Gmsh divides the boundaries itself. Debian's python3-netgen reads no models.\n")
    head(["domain, size"] + [peer.title for peer in peers])
    for job in lines:
        print(f"| {job.title} | " + " | ".join(peer_cell(af2, job, peer, folder) for peer in peers) + " |", flush=True)


if __name__ == "__main__":
    sys.exit(main())
