#!/usr/bin/python3
"""Times whole programs on a folder of CAD models, from file to file: AF2, and Gmsh and Netgen beside it.

    corpus_times.py --af2 build/cli/af2 [--every 3] [--gmsh PATH] [--netgen PATH] [--rounds 3] [--threads N] \
        [--output docs/performance.md] [--json table.json] FOLDER...

Every model is meshed at a fortieth of its diagonal, with 12 elements around a full turn and a
twentieth of the size as the least one, by each program in a process of its own, in turns within the
same run. With several rounds the least figure of each program and stage counts: other load only adds
to them. --threads is the same for all. With one thread, whole programs are compared by their user
seconds, with several by the time that passes; the meshers alone, from the shape in memory to the
surface mesh in memory, by the time that passes.

--gmsh is the program gmsh of any build. --netgen is a Python interpreter that has the module netgen of
any version since 6.2.2004, or the program netgen_driver, which is built with Debian's libnglib-dev and
has one thread.

User seconds and processor instructions (perf stat, if it works) are those of the whole process.
AF2's stages are the wall seconds of the report of a second run; "start" is the rest of its processor
time: linking, rules, and taking down. On a busy machine it comes out too small. Beside the table: sums, medians, triangles a second of edges,
surface and finishing together, and how Gmsh's and Netgen's times compare with those of AF2 on the
models that both mesh completely. --compare OLD.json prints what changed since an earlier run left
its table with --json.

A folder with an index.json takes "file" and "diag" from there; otherwise af2 inspect tells the
diagonal. Gmsh is the program gmsh, of any version: Frontal-Delaunay, binary .msh.
Only Python's standard library is needed.
"""

import argparse
import json
import os
import re
import resource
import shlex
import shutil
import statistics
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

import gmsh_file

SUFFIXES = {".step", ".stp", ".iges", ".igs", ".brep", ".brp"}
AF2, GMSH, NETGEN = "AF2", "Gmsh", "Netgen"
STAGES = ("read", "contacts", "edges", "surface", "optimize", "write")
FIGURES = ("user", "cpu", "wall", "mesher", "instructions", "start", *STAGES)
BEGIN, END = "<!-- corpus times: begin -->", "<!-- corpus times: end -->"


def options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folders", nargs="+", type=Path, help="folders or single models")
    parser.add_argument("--af2", required=True, help="the program af2")
    parser.add_argument("--gmsh", help="the program gmsh to compare with")
    parser.add_argument("--netgen", help="a Python with the module netgen, or the program netgen_driver")
    parser.add_argument("--every", type=int, default=1, help="only every so manieth model, in the order of their names")
    parser.add_argument("--only", default="", help="regular expression for the names of models")
    parser.add_argument("--parts", type=float, default=40, help="sizes along the diagonal of a model")
    parser.add_argument("--curvature", type=float, default=12, help="elements around a full turn")
    parser.add_argument("--least", type=float, default=20, help="the size over the least size")
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--threads", type=int, default=1, help="for all programs")
    parser.add_argument("--limit", type=float, default=30, help="seconds of processor time for one run")
    parser.add_argument("--json", type=Path, help="file for all that is known, in JSON")
    parser.add_argument("--compare", type=Path, help="table of an earlier run, in JSON: what changed since")
    parser.add_argument("--output", type=Path, help="page whose table is replaced; else printed")
    return parser.parse_args()


def diagonal_of(af2: str, model: Path) -> float:
    text = subprocess.run([af2, "inspect", "--brief", str(model)], capture_output=True, text=True,
                          errors="replace", check=False).stdout
    found = re.search(r"diagonal ([0-9.eE+-]+)", text)
    return float(found.group(1)) if found else 0.0


def models_of(chosen: argparse.Namespace) -> list:
    """Pairs of a model and its diagonal, by name."""
    found = {}
    for folder in chosen.folders:
        index = folder / "index.json"
        if folder.is_file():
            found[folder] = None
        elif index.exists():
            found.update({folder / entry["file"]: entry.get("diag") for entry in json.loads(index.read_text())})
        else:
            found.update({path: None for path in folder.rglob("*") if path.suffix.lower() in SUFFIXES})
    named = sorted(found.items(), key=lambda pair: (pair[0].stem, str(pair[0])))[::chosen.every]
    named = [(path, diagonal) for path, diagonal in named if re.search(chosen.only, path.stem)]
    return [(path, diagonal or diagonal_of(chosen.af2, path)) for path, diagonal in named]


def counts_instructions() -> bool:
    if not shutil.which("perf"):
        return False
    done = subprocess.run(["perf", "stat", "-x,", "-e", "instructions:u", "true"], capture_output=True, text=True,
                          check=False)
    return bool(re.match(r"\d+,", done.stderr))


def run(command: list, chosen: argparse.Namespace, folder: Path, has_perf: bool) -> dict:
    """Processor seconds, instructions, peak memory and exit code of a program."""
    counts = folder / "counts.txt"
    if has_perf:
        command = ["perf", "stat", "-x,", "-e", "instructions:u", "-o", str(counts), "--", *command]
    def forbid_more():
        limit = int(chosen.limit * chosen.threads)
        resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 1))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    begin = time.perf_counter()
    with open(folder / "log.txt", "w") as log:
        process = subprocess.Popen(command, stdout=log, stderr=log, cwd=folder, start_new_session=True,
                                   preexec_fn=forbid_more)
        # Something that waits without end uses no processor time.
        stopper = threading.Timer(4 * chosen.limit, lambda: os.killpg(process.pid, 9))
        stopper.start()
        _, status, usage = os.wait4(process.pid, 0)
        wall = time.perf_counter() - begin
        stopper.cancel()
    process.returncode = os.waitstatus_to_exitcode(status)
    found = {"user": usage.ru_utime, "cpu": usage.ru_utime + usage.ru_stime, "wall": wall, "mebibytes": usage.ru_maxrss / 1024,
             "exit": process.returncode, "instructions": 0}
    if has_perf and counts.exists():
        number = re.search(r"^(\d+),", counts.read_text(), re.MULTILINE)
        found["instructions"] = int(number.group(1)) if number else 0
    return found


def run_af2(chosen: argparse.Namespace, model: Path, size: float, folder: Path, has_perf: bool) -> dict:
    report = folder / "report.json"
    command = [chosen.af2, "mesh", str(model), "-q", "-s", repr(size), "--curvature", repr(chosen.curvature),
               "--min-size", repr(size / chosen.least), "-o", str(folder / "mesh.vtu"), "-j", str(chosen.threads)]
    found = run(command, chosen, folder, has_perf)
    # A report costs time of its own: it lists the parts that touch.
    with_report = run([*command, "--report", str(report)], chosen, folder, False)
    if not report.exists():
        return found
    told = json.loads(report.read_text())
    found.update({stage: told["seconds"].get(stage, 0.0) for stage in STAGES})
    found["start"] = max(0.0, with_report["cpu"] - sum(found[stage] for stage in STAGES)) if chosen.threads == 1 else 0.0
    found["mesher"] = sum(found[stage] for stage in ("edges", "surface", "optimize"))
    found["triangles"] = told["triangles"] + told["quads"]
    found["complete"] = told["status"] == "complete"
    found["fingerprint"] = told["fingerprint"]
    found["mean"], found["p1"], found["least"] = (told["quality"].get(key) for key in ("mean", "p1", "min"))
    found["faces"] = len(told["faces"])
    return found


def run_gmsh(chosen: argparse.Namespace, model: Path, size: float, folder: Path, has_perf: bool) -> dict:
    mesh = folder / "mesh.msh"
    found = run([chosen.gmsh, str(model), "-2", "-algo", "front2d", "-nt", str(chosen.threads),
                 "-clmax", repr(size), "-clmin", repr(size / chosen.least),
                 "-setnumber", "Mesh.MeshSizeFromCurvature", repr(chosen.curvature),
                 "-format", "msh41", "-bin", "-o", str(mesh)], chosen, folder, has_perf)
    if mesh.exists():
        found["triangles"], found["faces"] = gmsh_file.triangles_and_faces(mesh)
    log = (folder / "log.txt").read_text(errors="replace")
    found["mesher"] = sum(map(float, re.findall(r"Done meshing [12]D \(Wall ([0-9.e-]+)s", log))) or None
    found["complete"] = found["exit"] == 0 and bool(found.get("triangles")) and "Error " not in log
    return found


def netgen_command(chosen: argparse.Namespace, model: Path, size: float, mesh: Path) -> list:
    if "python" not in Path(chosen.netgen).name:
        return [chosen.netgen, str(model), repr(size), repr(chosen.curvature), str(mesh)]
    return [chosen.netgen, str(Path(__file__).with_name("netgen_file.py").resolve()), str(model), repr(size), str(mesh),
            "--curvature", repr(chosen.curvature), "--least", repr(size / chosen.least), "--threads", str(chosen.threads)]


def run_netgen(chosen: argparse.Namespace, model: Path, size: float, folder: Path, has_perf: bool) -> dict:
    mesh = folder / "netgen.obj"
    found = run(netgen_command(chosen, model, size, mesh), chosen, folder, has_perf)
    if mesh.exists():
        with open(mesh) as lines:
            found["triangles"] = sum(line.startswith("f ") for line in lines)
    told = re.search(r"^\{.*\}$", (folder / "log.txt").read_text(errors="replace"), re.MULTILINE)
    if told:
        told = json.loads(told.group(0))
        found["mesher"] = told.get("wall", told.get("seconds"))
    found["complete"] = found["exit"] == 0 and bool(found.get("triangles"))
    return found


def measure(chosen: argparse.Namespace, model: Path, diagonal: float, has_perf: bool) -> dict:
    """By program: the last run, with the least figures of all rounds."""
    runners = {AF2: run_af2}
    if chosen.gmsh:
        runners[GMSH] = run_gmsh
    if chosen.netgen:
        runners[NETGEN] = run_netgen
    best = {}
    for _ in range(chosen.rounds):
        for name, runner in runners.items():
            with tempfile.TemporaryDirectory() as folder:
                found = runner(chosen, model.resolve(), diagonal / chosen.parts, Path(folder), has_perf)
            for key in FIGURES:
                if best.get(name, {}).get(key) is not None:
                    found[key] = min(found.get(key) or best[name][key], best[name][key])
            best[name] = found
    return best


def rate(row: dict) -> float:
    """Triangles a second of edges, surface and finishing."""
    return row["triangles"] / max(1e-6, row["edges"] + row["surface"] + row["optimize"])


def ratio(found: dict, peer: str, figure: str) -> float | None:
    """How many times the time of AF2 the peer takes, where both are complete."""
    own, other = found[AF2], found.get(peer)
    both = other and own.get("complete") and other.get("complete") and other.get(figure)
    return other[figure] / max(own[figure], 1e-3) if both else None


def whole_program(chosen: argparse.Namespace) -> str:
    """The figure by which whole programs are compared."""
    return "user" if chosen.threads == 1 else "wall"


def cells(name: str, found: dict, peers: list, whole: str) -> str:
    row = found[AF2]
    if "triangles" not in row:
        return f"| {name} | refused | | {row[whole]:.3f} | {row['instructions'] / 1e6:,.0f} |" + " |" * (8 + 2 * len(peers))
    ratios = [ratio(found, peer, figure) for peer in peers for figure in (whole, "mesher")]
    stages = " | ".join(f"{row[stage]:.3f}" for stage in ("start", *STAGES))
    return (f"| {name} | {row['triangles']:,}{'' if row['complete'] else ' (incomplete)'} | {rate(row) / 1000:,.0f} | "
            f"{row[whole]:.3f} | {row['instructions'] / 1e6:,.0f} | {stages} |"
            + "".join(f" {one:.1f} |" if one else " |" for one in ratios))


def totals(table: dict, peers: list, figure: str) -> list:
    rows = [found[AF2] for found in table.values() if "triangles" in found[AF2]]
    whole = {key: sum(row[key] for row in rows) for key in ("triangles", *FIGURES)}
    lines = [cells(f"sum of {len(rows)}", {AF2: {**whole, "complete": True}}, [], figure) + " |" * 2 * len(peers)]
    middle = {key: statistics.median(row[key] for row in rows) for key in whole}
    lines.append(cells("median", {AF2: {**middle, "triangles": int(middle["triangles"]), "complete": True}}, [], figure)
                 .replace(f"| {rate(middle) / 1000:,.0f} |", f"| {statistics.median(map(rate, rows)) / 1000:,.0f} |", 1)
                 + " |" * 2 * len(peers))
    return lines


def about_peer(table: dict, peer: str, figure: str, what: str) -> str:
    both = {name: ratio(found, peer, figure) for name, found in table.items() if ratio(found, peer, figure)}
    if not both:
        return f"{peer}, {what}: no model that both mesh completely."
    sums = [sum(table[name][program][figure] for name in both) for program in (peer, AF2)]
    slower = sorted((name for name in both if both[name] < 1), key=both.get)
    return (f"{peer}'s time over AF2's, {what}, {len(both)} models that both mesh completely: "
            f"median {statistics.median(both.values()):.2f}, of the sums {sums[0] / sums[1]:.2f} "
            f"({sums[0]:.2f} s and {sums[1]:.2f} s), below 1 on {len(slower)}"
            + (": " + ", ".join(f"{name} {both[name]:.2f}" for name in slower) if slower else "") + ".")


INSTRUCTIONS = 5  # the column, counted from the text before the first bar


def without_column(line: str, column: int) -> str:
    parts = line.split("|")
    return "|".join(parts[:column] + parts[column + 1:])


def summary(table: dict, chosen: argparse.Namespace) -> list:
    peers = [name for name, path in ((GMSH, chosen.gmsh), (NETGEN, chosen.netgen)) if path]
    whole = whole_program(chosen)
    head = ["model", "triangles", "1000/s", f"{whole} s", "10^6 instructions", "start", *STAGES,
            *(title for peer in peers for title in (f"{peer} / AF2", f"{peer}'s mesher / AF2's"))]
    folders = {str(folder) for folder in chosen.folders}
    words = ["FOLDER" if word in folders else word for word in sys.argv[1:]]
    lines = ["```", shlex.join(["tests/benchmark/corpus_times.py", *words]), "```", ""]
    for peer in peers:
        lines += [about_peer(table, peer, whole, f"whole programs, {whole} seconds, {chosen.threads} threads"), "",
                  about_peer(table, peer, "mesher", "the meshers alone, seconds that pass"), ""]
    rows = ["| " + " | ".join(head) + " |", "|---|" + "---:|" * (len(head) - 1)]
    rows += totals(table, peers, whole) + [cells(name, found, peers, whole) for name, found in table.items()]
    if not any(found[AF2]["instructions"] for found in table.values()):  # they could not be counted
        rows = [without_column(row, INSTRUCTIONS) for row in rows]
    return lines + rows


def changes(earlier: dict, table: dict) -> list:
    """Sums over the models of both tables, and the models whose mesh changed."""
    common = [name for name in table if "triangles" in table[name][AF2]
              and "triangles" in earlier.get(name, {}).get(AF2, {})]
    lines = []
    for key in ("instructions", "user", "triangles"):
        old, new = (sum(one[name][AF2][key] for name in common) for one in (earlier, table))
        lines.append(f"{key}: {old:,.10g} -> {new:,.10g} ({100 * (new / old - 1) if old else 0:+.1f} %)")
    for name in common:
        old, new = earlier[name][AF2], table[name][AF2]
        if old["fingerprint"] != new["fingerprint"] or old["complete"] != new["complete"]:
            lines.append(f"{name}: {old['triangles']} -> {new['triangles']} triangles, quality mean {old['mean']:.4f} -> "
                         f"{new['mean']:.4f}, 1 % {old['p1']:.3f} -> {new['p1']:.3f}, least {old['least']:.3f} -> "
                         f"{new['least']:.3f}" + ("" if new["complete"] else ", incomplete"))
    return lines


def write(lines: list, output: Path | None) -> None:
    text = "\n".join(lines) + "\n"
    if output is None:
        print(text, end="")
        return
    page = output.read_text()
    if BEGIN not in page or END not in page:
        sys.exit(f"{output} lacks the lines '{BEGIN}' and '{END}'")
    output.write_text(f"{page.split(BEGIN, 1)[0]}{BEGIN}\n{text}{END}{page.split(END, 1)[1]}")


def main() -> int:
    chosen = options()
    chosen.af2 = str(Path(chosen.af2).resolve())
    # A link to a Python, as in a virtual environment, is not the same as what it leads to.
    chosen.netgen = chosen.netgen and os.path.abspath(chosen.netgen)
    chosen.gmsh = chosen.gmsh and (shutil.which(chosen.gmsh) or sys.exit(f"there is no program {chosen.gmsh}"))
    has_perf, table = counts_instructions(), {}
    for model, diagonal in models_of(chosen):
        if not diagonal:
            print(f"{model.stem}: no diagonal", file=sys.stderr)
            continue
        table[model.stem] = measure(chosen, model, diagonal, has_perf)
        print(cells(model.stem, table[model.stem], [name for name in table[model.stem] if name != AF2],
                    whole_program(chosen)), file=sys.stderr)
    if not any("triangles" in found[AF2] for found in table.values()):
        sys.exit("no model that AF2 meshes")
    if chosen.json:
        chosen.json.write_text(json.dumps(table, indent=1))
    write(summary(table, chosen), chosen.output)
    if chosen.compare:
        print("\n".join(changes(json.loads(chosen.compare.read_text()), table)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
