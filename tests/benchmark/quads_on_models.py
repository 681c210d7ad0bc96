#!/usr/bin/env python3
"""Quadrilaterals on a folder of CAD models, beside those of Gmsh.

    quads_on_models.py AF2 FOLDER [--every N] [--rules RULES] [--gmsh PATH]

Every model is meshed at a fortieth of its diagonal, once with quadrilaterals wherever the rules make them, as Gmsh does, and
once with --elements quad, which leaves no triangles. Prints a table in Markdown, with the mean and the first percentile of
the scaled Jacobian of the quadrilaterals, and on how many models AF2 has more, for each of Gmsh's ways that meshes the
model. The folder has an index.json with "file" and "diag".
"""
import argparse
import json
import pathlib
import subprocess
import tempfile

import quad_peers


def measured(af2, mesh):
    """Numbers of quadrilaterals and triangles, mean and first percentile of the scaled Jacobian; None: no mesh."""
    run = subprocess.run([af2, "quality", mesh, "--format", "json"], capture_output=True, text=True)
    found = json.loads(run.stdout) if run.returncode == 0 else {}
    jacobian = found.get("scaled_jacobian", {}).get("quads")
    return (found["quads"], found["triangles"], jacobian["mean"], jacobian["p1"]) if jacobian else None


def by_af2(af2, model, size, rules, options, folder):
    mesh = folder / "af2.msh"
    mesh.unlink(missing_ok=True)
    subprocess.run([af2, "mesh", model, "--size", repr(size), "-r", rules, "-q", "-j", "1", "-o", mesh, *options],
                   capture_output=True)
    return measured(af2, mesh) if mesh.exists() else None


def by_gmsh(af2, gmsh, model, size, folder):
    mesh, _ = gmsh.mesh_model(model, size, folder)
    return measured(af2, mesh) if mesh else None


def cell(figures):
    if not figures:
        return "none"
    quads, triangles, mean, p1 = figures
    return f"{mean:.3f} / {p1:.2f} ({quads}{f', {triangles} tri' if triangles else ''})"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("af2", type=lambda name: pathlib.Path(name).resolve())
    parser.add_argument("folder", type=lambda name: pathlib.Path(name).resolve())
    parser.add_argument("--every", type=int, default=1, help="only every so manieth model, in the order of their names")
    parser.add_argument("--rules", default="quad/classic")
    parser.add_argument("--gmsh", default=quad_peers.places["gmsh"], metavar="PATH", help="the program gmsh")
    chosen = parser.parse_args()
    quad_peers.places["gmsh"] = chosen.gmsh
    models = sorted(json.loads((chosen.folder / "index.json").read_text()), key=lambda model: model["name"])
    models = [model for model in models if model.get("diag")][::chosen.every]
    ways = [quad_peers.Gmsh("Gmsh, Blossom", quad_peers.FRONTAL, quad_peers.BLOSSOM),
            quad_peers.Gmsh("Gmsh, packing", quad_peers.PACKING, quad_peers.BLOSSOM)]
    titles = [f"AF2, {chosen.rules}", "AF2, --elements quad"]
    print("| model | " + " | ".join(titles + [way.title for way in ways]) + " |")
    print("|---" * (1 + len(titles) + len(ways)) + "|")
    better = {title: [0, 0, 0] for title in titles}  # mean, p1, of how many
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for model in models:
            path, size = chosen.folder / model["file"], model["diag"] / 40
            ours = [by_af2(chosen.af2, path, size, chosen.rules, options, folder) for options in ([], ["--elements", "quad"])]
            theirs = [by_gmsh(chosen.af2, way, path, size, folder) for way in ways]
            print(f"| {model['name']} | " + " | ".join(map(cell, ours + theirs)) + " |", flush=True)
            for title, own in zip(titles, ours):
                for other in filter(None, theirs):
                    if own:
                        better[title] = [better[title][0] + (own[2] >= other[2]), better[title][1] + (own[3] >= other[3]),
                                         better[title][2] + 1]
    for title, (mean, p1, count) in better.items():
        print(f"\n{title}: mean as large or larger in {mean} of {count} comparisons, first percentile in {p1}")


if __name__ == "__main__":
    main()
