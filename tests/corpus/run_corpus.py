#!/usr/bin/python3
"""Meshes every CAD model of some folders and writes one table: what came of each.

    run_corpus.py --af2 build/cli/af2 FOLDER... [-j 2] [--limit 60] [--output table.md]
    run_corpus.py --af2 build/cli/af2 FOLDER... --into docs/corpus.md --section NAME
    run_corpus.py --from table.json --into docs/corpus.md --section NAME

A second table counts the models that are not complete and sound by cause. With --compare OLD.json,
the table that an earlier run left with --json, the program prints what changed since, and the exit
code is also 1 if a model is no longer complete and sound. FOLDER is any folder with models, in
subfolders too.

With --into, the table replaces what stands between the comments `begin NAME` and `end NAME` of a
page; with --from, it is the one that an earlier run left with --json.

Of a folder with thousands of models, --sample 150 takes those whose names come first when ordered
by a checksum: the same ones everywhere. Another word for --draw gives another sample.

With --stl build/tests/corpus/write_stl each model is written as STL first, and the triangles are
meshed. What cannot be written counts as refused.

The runs with --scale 0.7 and 1.5 and with --curvature 12 stand in for models that are not at hand.

Each model runs in a process of its own with a time limit, at a size of a fortieth of its diagonal
unless the folder has an index.json that gives one ("file", "h"). What AF2 delivers is examined by
mesh_oracle.py, which shares no code with it. The exit code is 1 if a run crashed, hung, gave an
exit code that does not fit its report, or called a mesh complete that is not sound.

Needs NumPy (Debian: python3-numpy).
"""

import argparse
import hashlib
import json
import os
import re
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass, field
from pathlib import Path

import mesh_oracle
from corpus_changes import changes, has_worse, table_of_causes

SUFFIXES = {".step", ".stp", ".iges", ".igs", ".brep", ".brp", ".rle", ".stl", ".obj", ".ply", ".off"}
DIAGONALS_PER_SIZE = 40
MOST_AREA_ERROR = 0.05
LEAST_ANGLE = 0.5


@dataclass
class Row:
    model: str
    size: float = 0.0
    exit_code: int = 0
    status: str = ""
    faces: int = 0
    failed: int = 0
    closed_by_hand: int = 0
    elements: int = 0
    quads: int = 0
    faces_with_triangles: int = 0  # only with --elements quad
    mean: float = 0.0
    p1: float = 0.0
    min_angle: float = 0.0
    open_edges: int = 0
    multiple_edges: int = 0
    intersections: int = 0
    folds: int = 0
    area_error: float = 0.0  # the largest over the faces
    total_area_error: float = 0.0
    seconds: float = 0.0  # of processor time, which does not depend on what else runs
    wall: float = 0.0
    reason: str = ""
    faults: list = field(default_factory=list)
    notes: list = field(default_factory=list)


def options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folders", nargs="*", type=Path, help="folders or single models")
    parser.add_argument("--af2", help="the program")
    parser.add_argument("--from", dest="earlier", type=Path, help="table of an earlier run, in JSON")
    parser.add_argument("--compare", type=Path, help="table of an earlier run, in JSON: what changed since")
    parser.add_argument("--into", type=Path, help="page in Markdown that gets the table")
    parser.add_argument("--section", help="which part of that page")
    parser.add_argument("--rules", help="rule file; default: that of AF2")
    parser.add_argument("--elements", choices=("any", "quad"), default="any")
    parser.add_argument("--scale", type=float, default=1, help="multiplies all sizes")
    parser.add_argument("--curvature", type=float, help="elements around a full turn")
    parser.add_argument("-j", type=int, default=1, help="models at the same time")
    parser.add_argument("--limit", type=float, default=60, help="seconds for each model")
    parser.add_argument("--only", default="", help="regular expression for the names of models")
    parser.add_argument("--sample", type=int, default=0, help="so many models only, drawn by their names")
    parser.add_argument("--draw", default="1", help="a word that the sample depends on")
    parser.add_argument("--stl", type=Path, help="program that writes a model as STL, which is meshed then")
    parser.add_argument("--output", type=Path, help="file for the table in Markdown")
    parser.add_argument("--json", type=Path, help="file for all that is known, in JSON")
    parser.add_argument("--keep", type=Path, help="folder that keeps the meshes and reports")
    parser.add_argument("--no-oracle", action="store_true", help="believe AF2's own checks")
    arguments = parser.parse_args()
    if not arguments.earlier and not (arguments.af2 and arguments.folders):
        parser.error("give --af2 and folders of models, or --from a table")
    if bool(arguments.into) != bool(arguments.section):
        parser.error("--into needs --section, and the other way round")
    return arguments


def models_of(folder: Path) -> list:
    """Pairs of a model and its size, 0 where none is given."""
    if folder.is_file():
        return [(folder, 0.0)]
    index = folder / "index.json"
    if index.exists():
        return [(folder / entry["file"], entry.get("h") or 0.0) for entry in json.loads(index.read_text())]
    return [(path, 0.0) for path in sorted(folder.rglob("*")) if path.suffix.lower() in SUFFIXES]


def sample_of(models: list, count: int, draw: str) -> list:
    """Depends on the names of the models alone, not on their order or on what else there is."""
    def rank(model) -> str:
        return hashlib.sha256(f"{draw}/{model[0].name}".encode()).hexdigest()

    drawn = sorted(models, key=rank)[:count]
    return [model for model in models if model in drawn]


def default_size(af2: str, model: Path) -> float:
    try:
        text = subprocess.run([af2, "inspect", "--brief", str(model)], capture_output=True, text=True,
                              timeout=60, errors="replace").stdout
    except subprocess.TimeoutExpired:
        return 0.0
    found = re.search(r"diagonal ([0-9.eE+-]+)", text)
    return float(found.group(1)) / DIAGONALS_PER_SIZE if found else 0.0


def run_one(arguments: argparse.Namespace, model: Path, size: float) -> Row:
    row = Row(model.stem, arguments.scale * (size or default_size(arguments.af2, model) or 1.0))
    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.keep or Path(temporary)
        mesh, report = folder / (model.stem + ".vtu"), folder / (model.stem + ".json")
        for old in (mesh, report):
            old.unlink(missing_ok=True)
        source = model
        if arguments.stl:
            source = Path(temporary) / (model.stem + ".stl")
            if not write_triangles(arguments, model, source):
                row.status, row.exit_code, row.reason = "refused", 1, "not written as STL"
                return row
        command = [arguments.af2, "mesh", str(source), "-q", "-s", repr(row.size), "-o", str(mesh),
                   "--report", str(report), "-j", "1", "--elements", arguments.elements]
        if arguments.rules:
            command += ["-r", arguments.rules]
        if arguments.curvature:
            command += ["--curvature", repr(arguments.curvature)]
        run_limited(row, command, arguments.limit)
        if report.exists() and row.status != "hang":
            read_report(row, json.loads(report.read_text()))
        if row.status != "hang" and mesh.exists() and not arguments.no_oracle:
            hold_against_oracle(row, mesh, json.loads(report.read_text()))
    judge(row)
    return row


def write_triangles(arguments: argparse.Namespace, model: Path, target: Path) -> bool:
    try:
        subprocess.run([arguments.stl, model, target], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                       timeout=arguments.limit)
    except subprocess.TimeoutExpired:
        return False
    return target.exists()


def run_limited(row: Row, command: list, limit: float) -> None:
    """Runs a command, and ends it when it has used up its seconds of processor time."""
    def forbid_more():
        resource.setrlimit(resource.RLIMIT_CPU, (int(limit), int(limit) + 1))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    with tempfile.TemporaryFile() as errors:
        start = time.monotonic()
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=errors,
                                   preexec_fn=forbid_more)
        # Something that waits without end uses no processor time.
        stopper = threading.Timer(20 * limit, process.kill)
        stopper.start()
        _, status, usage = os.wait4(process.pid, 0)
        stopper.cancel()
        process.returncode = row.exit_code = os.waitstatus_to_exitcode(status)
        row.wall = time.monotonic() - start
        row.seconds = usage.ru_utime + usage.ru_stime
        errors.seek(0)
        row.reason = errors.read().decode(errors="replace").strip().split("\n")[0]
    # AF2 meshes in a child process, and tells if that is ended.
    if -row.exit_code in (signal.SIGXCPU, signal.SIGKILL) or "CPU time limit" in row.reason:
        row.status, row.reason = "hang", f"no end after {limit:g} s"


def read_report(row: Row, report: dict) -> None:
    row.status = report["status"]
    row.faces = len(report["faces"])
    failed = [face for face in report["faces"] if face["status"] == "failed"]
    row.failed = len(failed)
    row.quads = report["quads"]
    row.elements = report["triangles"] + row.quads
    row.faces_with_triangles = sum(f.get("triangles", 0) > 0 for f in report["faces"])
    row.mean, row.p1 = report["quality"]["mean"], report["quality"]["p1"]
    row.min_angle = report["quality"]["min_angle"]
    row.notes = [f"face {f['id']} ({f['surface_type']}): {f['reason']}" for f in report["faces"] if f["reason"]]
    if failed:
        row.reason = f"face {failed[0]['id']} ({failed[0]['surface_type']}): {failed[0]['reason']}"
    elif report.get("reason"):
        row.reason = report["reason"]


def hold_against_oracle(row: Row, mesh: Path, report: dict) -> None:
    found = mesh_oracle.examine(mesh)
    row.min_angle = found.min_angle
    row.open_edges, row.multiple_edges = found.open_edges, found.multiple_edges
    row.intersections, row.folds = found.intersections, found.folds
    if found.turned_edges:
        row.faults.append(f"{found.turned_edges} edges with triangles in the same direction")
    if found.examples:
        row.notes.append(f"intersections at {found.examples}")
    total = wanted_total = 0.0
    for face in report["faces"]:
        wanted, got = face.get("area", 0), found.area.get(face["id"], 0)
        if face["status"] != "complete" or not wanted > 0:
            continue
        total, wanted_total = total + got, wanted_total + wanted
        error = abs(got / wanted - 1)
        if error > row.area_error:
            row.area_error = error
        if error > MOST_AREA_ERROR:
            row.notes.append(f"face {face['id']} ({face['surface_type']}): {got / wanted:.3f} of its area {wanted:.3g}")
    row.total_area_error = abs(total / wanted_total - 1) if wanted_total else 0.0


def judge(row: Row) -> None:
    codes = {"complete": 0, "partial": 3, "failed": 3}
    if row.status == "hang":
        row.faults.append("no end")
    elif row.exit_code < 0:
        row.status = "crash"
        row.faults.append(f"signal {-row.exit_code}")
    elif row.exit_code == 1:
        row.status = "refused"
        if not row.reason:
            row.faults.append("refused without a reason")
    elif codes.get(row.status) != row.exit_code:
        row.faults.append(f"exit code {row.exit_code} with status {row.status!r}")
    if row.status == "complete":
        if row.intersections or row.folds:
            row.faults.append(f"{row.intersections} intersections, {row.folds} folds")
        if row.total_area_error > MOST_AREA_ERROR:
            row.faults.append(f"area wrong by {100 * row.total_area_error:.1f} %")
        if row.min_angle < LEAST_ANGLE:
            row.faults.append(f"angle of {row.min_angle:.2g} degrees")


def table(rows: list) -> str:
    head = ("model", "status", "faces", "failed", "elements", "mean", "1 %", "least angle", "open", ">2",
            "cross", "area", "s", "remark")
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    for r in rows:
        remark = "; ".join(r.faults) or (r.reason if r.status != "complete" else "")
        remark = re.sub(r"^(af2: )?(error: )?\S*/(?=[^/ ]+: )", "", remark).replace("|", "/")
        lines.append(f"| {r.model} | {r.status} | {r.faces} | {r.failed} | {r.elements} | {r.mean:.3f} | {r.p1:.3f} | "
                     f"{r.min_angle:.1f} | {r.open_edges} | {r.multiple_edges} | {r.intersections + r.folds} | "
                     f"{100 * r.area_error:.1f} % | {r.seconds:.1f} | {remark[:160]} |")
    return "\n".join(lines)


def about_quads(rows: list) -> str:
    quads, elements, faces, others = (sum(getattr(r, name) for r in rows)
                                      for name in ("quads", "elements", "faces", "faces_with_triangles"))
    if quads == 0:
        return ""
    return (f" {100 * quads / elements:.2f} % of the elements are quadrilaterals. With --elements quad: "
            f"{others} of {faces} faces ({100 * others / faces:.1f} %) have triangles.")


def summary(rows: list) -> str:
    count = {}
    for row in rows:
        count[row.status] = count.get(row.status, 0) + 1
    readable = [row for row in rows if row.status != "refused"]
    sound = [row for row in readable if row.status == "complete" and not row.faults]
    text = ", ".join(f"{n} {status}" for status, n in sorted(count.items()))
    share = 100 * len(sound) / max(len(readable), 1)
    return (f"{len(rows)} models: {text}. Of {len(readable)} that were read, {len(sound)} ({share:.1f} %) are complete "
            f"and sound; {sum(r.elements for r in rows)} elements, {sum(r.seconds for r in rows):.0f} s, "
            f"the slowest {max(r.seconds for r in rows):.1f} s." + about_quads(rows))


def replace_section(page: Path, section: str, text: str) -> None:
    begin, end = f"<!-- begin {section} -->", f"<!-- end {section} -->"
    whole = page.read_text()
    if whole.count(begin) != 1 or whole.count(end) != 1:
        sys.exit(f"{page} lacks the comments '{begin}' and '{end}'")
    before, rest = whole.split(begin)
    after = rest.split(end)[1]
    page.write_text(f"{before}{begin}\n{text}{end}{after}")


def run_all(arguments: argparse.Namespace) -> list:
    if arguments.keep:
        arguments.keep.mkdir(parents=True, exist_ok=True)
    models = [m for folder in arguments.folders for m in models_of(folder)
              if re.search(arguments.only, m[0].stem)]
    if not models:
        sys.exit("no models found")
    if arguments.sample:
        models = sample_of(models, arguments.sample, arguments.draw)
    with ThreadPoolExecutor(arguments.j) as pool:
        return list(pool.map(lambda m: run_one(arguments, *m), models))


def rows_of(file: Path) -> list:
    return [Row(**row) for row in json.loads(file.read_text())]


def main() -> int:
    arguments = options()
    earlier = rows_of(arguments.compare) if arguments.compare else []
    if arguments.earlier:
        rows = rows_of(arguments.earlier)
    else:
        rows = run_all(arguments)
    text = summary(rows) + "\n\n" + table_of_causes(rows) + "\n\n" + table(rows) + "\n"
    if arguments.into:
        replace_section(arguments.into, arguments.section, text)
    else:
        print(text)
    if arguments.output:
        arguments.output.write_text(text)
    if arguments.json:
        arguments.json.write_text(json.dumps([asdict(row) for row in rows], indent=1))
    if arguments.compare:
        print(f"\nCompared with {arguments.compare}: {changes(earlier, rows)}")
    bad = [row for row in rows if row.faults and row.status in ("crash", "hang", "complete")]
    return 1 if bad or has_worse(earlier, rows) else 0


if __name__ == "__main__":
    sys.exit(main())
