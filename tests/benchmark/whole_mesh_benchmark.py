#!/usr/bin/python3
"""Compares AF2 with Netgen and Gmsh on whole CAD models, at uniform sizes.

    whole_mesh_benchmark.py --af2 BUILD/tests/benchmark/whole_mesh_benchmark \
        [--netgen BUILD/tests/benchmark/netgen_driver] [--gmsh [PATH]] [--output docs/benchmarks.md] \
        [--models examples/models DIRECTORY] [--only die sphere:0.5,0.25]

Each program meshes in a process of its own, one thread, in turns within the same run, so that all
of them see the same state of the machine. Seconds are user time from the model in memory to the
mesh in memory, edges and faces; the median over the rounds counts. The raw front of AF2 is held
against the raw front of Netgen, its finished mesh against Gmsh. Quality is printed beside speed,
so that none is bought with the other. A program that is not there is left out. Only Python's
standard library is needed.
"""

import argparse
import json
import platform
import re
import shlex
import statistics
import subprocess
import sys
from pathlib import Path

MODELS = ("brickhole", "cylinder", "die")
SIZES = (0.5, 0.25, 0.125, 0.0625, 0.03125)
REPOSITORY = Path(__file__).resolve().parents[2]
RAW, FINISHED = "AF2, raw front", "AF2, finished"
NETGEN, GMSH = "Netgen, raw front", "Gmsh, Frontal-Delaunay"
RIVAL_OF = {NETGEN: RAW, GMSH: FINISHED}
BEGIN, END = "<!-- whole meshes: begin -->", "<!-- whole meshes: end -->"


def options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--af2", required=True, help="the program whole_mesh_benchmark")
    parser.add_argument("--netgen", help="the program netgen_driver, if it was built")
    parser.add_argument("--gmsh", nargs="?", const="", metavar="PATH",
                        help="the program gmsh of any build; without PATH, Debian's Python module is used")
    parser.add_argument("--models", type=Path, nargs="+", help="directories with STEP files",
                        default=[REPOSITORY / "examples" / "models"])
    parser.add_argument("--only", nargs="+", default=MODELS, metavar="MODEL[:SIZE,...]",
                        help="names without .step; with sizes of their own, if --sizes do not fit")
    parser.add_argument("--sizes", nargs="+", type=float, default=SIZES)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--timeout", type=float, default=300, help="seconds for one mesh")
    parser.add_argument("--output", type=Path, help="file whose table is replaced; else printed")
    return parser.parse_args()


def programs(chosen: argparse.Namespace) -> dict[str, list[str]]:
    commands = {RAW: [chosen.af2], FINISHED: [chosen.af2, "--optimize"]}
    if chosen.netgen:
        commands[NETGEN] = [chosen.netgen]
    if chosen.gmsh is not None:
        commands[GMSH] = ["/usr/bin/python3", str(Path(__file__).with_name("gmsh_driver.py")),
                          *(["--program", chosen.gmsh] if chosen.gmsh else [])]
    return commands


def run_once(command: list[str], model: Path, size: float, timeout: float) -> dict | None:
    """The result line of one run; None if the program failed or took too long."""
    try:
        done = subprocess.run([*command, str(model), repr(size)], capture_output=True, text=True,
                              timeout=timeout, check=False)
        result = json.loads(done.stdout) if done.returncode == 0 else None
    except (subprocess.TimeoutExpired, json.JSONDecodeError):
        return None
    return result if result and result.get("triangles") else None


def measure(commands: dict[str, list[str]], model: Path, size: float,
            chosen: argparse.Namespace) -> dict[str, dict]:
    """By program: its last result, with the median of its seconds."""
    results: dict[str, dict] = {}
    seconds: dict[str, list[float]] = {}
    failed = set()
    for _ in range(chosen.rounds):
        for name, command in commands.items():
            result = None if name in failed else run_once(command, model, size, chosen.timeout)
            if result is None:
                failed.add(name)
                continue
            results[name] = result
            seconds.setdefault(name, []).append(result["seconds"])
    for name, result in results.items():
        result["seconds"] = statistics.median(seconds[name])
        result["rate"] = result["triangles"] / max(result["seconds"], 1e-6)
    return {name: result for name, result in results.items() if name not in failed}


def row(model: str, size: float, name: str, results: dict[str, dict]) -> str:
    result, own = results.get(name), results.get(RIVAL_OF.get(name, ""))
    if result is None:
        return f"| {model} | {size:g} | {name} | - | - | failed | | | | | |"
    ratio = f"{own['rate'] / result['rate']:.1f}" if own else ""
    return (f"| {model} | {size:g} | {name} | {result['triangles']:,} | {result['seconds']:.3f} | "
            f"{result['rate'] / 1000:,.0f} | {ratio} | {result['min']:.3f} | "
            f"{result['percentile1']:.3f} | {result['mean']:.4f} | {result['mebibytes']:.0f} |")


def tasks_of(entry: str, chosen: argparse.Namespace) -> tuple[str, list[float]]:
    """A model and its sizes from MODEL or MODEL:SIZE,SIZE."""
    model, _, sizes = entry.partition(":")
    return model, [float(size) for size in sizes.split(",")] if sizes else chosen.sizes


def file_of(model: str, chosen: argparse.Namespace) -> Path:
    for directory in chosen.models:
        if (directory / f"{model}.step").exists():
            return directory / f"{model}.step"
    sys.exit(f"there is no {model}.step in {', '.join(map(str, chosen.models))}")


def table(commands: dict[str, list[str]], chosen: argparse.Namespace) -> list[str]:
    lines = ["| model | size | program | triangles | user s | 1000/s | AF2 is faster by | "
             "min | 1st percentile | mean | MiB |",
             "|---|---|---|---:|---:|---:|---:|---:|---:|---:|---:|"]
    for model, sizes in (tasks_of(entry, chosen) for entry in chosen.only):
        for size in sizes:
            found = measure(commands, file_of(model, chosen), size, chosen)
            for name in commands:
                lines.append(row(model, size, name, found))
                print(lines[-1], file=sys.stderr)
    return lines


def processor() -> str:
    try:
        found = re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text())
    except OSError:
        found = None
    return found.group(1) if found else platform.processor()


def output_of(*command: str) -> str:
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError:
        return ""
    return done.stdout.strip()


def version(package: str) -> str:
    return output_of("dpkg-query", "-W", "-f", "${Version}", package)


def commit() -> str:
    return output_of("git", "-C", str(REPOSITORY), "rev-parse", "--short", "HEAD") or "unknown"


def heading(commands: dict[str, list[str]], chosen: argparse.Namespace) -> list[str]:
    packages = {NETGEN: "libnglib-dev", GMSH: "gmsh"}
    peers = [f"{packages[name]} {version(packages[name])}" for name in commands if name in packages]
    if chosen.gmsh:
        told = subprocess.run([chosen.gmsh, "--version"], capture_output=True, text=True, check=False)
        peers = [f"gmsh {(told.stdout + told.stderr).strip()}" if peer.startswith("gmsh ") else peer for peer in peers]
    shown = shlex.join(["tests/benchmark/whole_mesh_benchmark.py", *sys.argv[1:]])
    return [f"Measured on {processor()}, commit {commit()}, one thread, "
            f"median of {chosen.rounds} rounds"
            + (f", against {' and '.join(peers)}" if peers else "") + ":", "",
            "```", shown, "```", ""]


def write(lines: list[str], output: Path | None) -> None:
    """Replaces what stands between the two marks of the file, or prints."""
    text = "\n".join(lines) + "\n"
    if output is None:
        print(text, end="")
        return
    page = output.read_text() if output.exists() else f"# Benchmarks\n\n{BEGIN}\n{END}\n"
    if BEGIN not in page or END not in page:
        sys.exit(f"{output}: the lines '{BEGIN}' and '{END}' are missing; "
                 "put them where the table shall stand")
    before, rest = page.split(BEGIN, 1)
    after = rest.split(END, 1)[1]
    output.write_text(f"{before}{BEGIN}\n{text}{END}{after}")


def main() -> int:
    chosen = options()
    commands = programs(chosen)
    lines = heading(commands, chosen)
    write(lines + table(commands, chosen), chosen.output)
    return 0


if __name__ == "__main__":
    sys.exit(main())
