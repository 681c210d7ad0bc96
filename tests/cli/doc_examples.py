"""Compiles the examples of the documentation: doc_examples.py PROGRAM SOURCE.

A block fenced as ```af2 is a rule file, or items of one, or a meta clause; what is missing is added.
"```af2 finds A1" must have the finding A1, and "```af2 NAME.af2" is added to a file that grows through
its page and is checked after each addition. Tests in the blocks must pass. Lines that begin with "$ af2"
in ```console blocks are run, in one folder for each page; "# exit code 3" at the end says what is expected."""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

PROGRAM, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
FENCE = re.compile(r"^```(\w+)([^\n]*)\n(.*?)^```$", re.M | re.S)
FREE_RULE = 'rule "any" quality 1 {\n  new c = mid(a, b) + (0, 0.866);\n  zone a, b, c;\n  tri a b c;\n'
failures = []


def run(*arguments, folder=None):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, cwd=folder, timeout=300)


def has_cad():
    return json.loads(run("version", "--json").stdout)["opencascade"]


def completed(text):
    """The whole file that an excerpt stands for."""
    if text.startswith("af2 "):
        return text
    if text.startswith("meta"):
        text = FREE_RULE + text + "}\n"
    if not re.search(r"^ruleset ", text, re.M):
        text += 'ruleset "example" { elements tri, quad; }\n'
    if not re.search(r"^(rule|use) ", text, re.M):
        text += FREE_RULE + "}\n"
    return "af2 1;\n" + text


def check(place, name, folder, code):
    """Checks and tests a file in a folder."""
    found = run("check", "--quick", "--format", "json", name, folder=folder)
    diagnostics = json.loads(found.stdout)
    codes = [d["code"] for d in diagnostics]
    if code:
        if code not in codes:
            failures.append(f"{place}: expected the finding {code}, got {codes}")
        return
    if found.returncode != 0:
        failures.append(f"{place}:\n" + run("check", "--quick", name, folder=folder).stdout)
        return
    tested = run("test", name, folder=folder)
    if tested.returncode != 0:
        failures.append(f"{place}:\n" + tested.stdout + tested.stderr)


def commands(place, text, folder):
    for line in text.splitlines():
        if not line.startswith("$ af2 "):
            continue
        command = line[2:].replace("af2", f"'{PROGRAM}'", 1)
        if not has_cad() and (".step" in line or ".brep" in line):
            continue
        wanted = int(line.partition("# exit code ")[2] or 0)
        done = subprocess.run(command, shell=True, capture_output=True, text=True, cwd=folder, timeout=600)
        if done.returncode != wanted:
            failures.append(f"{place}: exit code {done.returncode}: {line}\n{done.stdout}{done.stderr}")


def examine(page):
    text = page.read_text(encoding="utf-8")
    count = 0
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(SOURCE / "examples", pathlib.Path(folder) / "examples")
        for match in FENCE.finditer(text):
            language, info, body = match.group(1), match.group(2).strip(), match.group(3)
            place = f"{page.relative_to(SOURCE)}:{text.count(chr(10), 0, match.start()) + 1}"
            if language == "console":
                commands(place, body, folder)
            if language != "af2":
                continue
            count += 1
            name, _, code = info.partition("finds ")
            if name.strip():
                with open(pathlib.Path(folder) / name.strip(), "a", encoding="utf-8") as file:
                    file.write(body)
                check(place, name.strip(), folder, code)
            else:
                example = pathlib.Path(folder) / "example.af2"
                example.write_text(completed(body), encoding="utf-8")
                check(place, example.name, folder, code)
    return count


pages = [SOURCE / "README.md", *sorted((SOURCE / "docs").glob("*.md"))]
total = sum(examine(page) for page in pages)
print("\n".join(failures) if failures else f"all {total} examples are sound")
sys.exit(1 if failures or total == 0 else 0)
