"""Compiles the examples of the documentation: doc_examples.py PROGRAM SOURCE [PAGE...].

A block fenced as ```af2 is a rule file, or items of one, or a meta clause; what is missing is added.
"```af2 finds A1" must have the finding A1, and "```af2 NAME.af2" is added to a file that grows through
its page and is checked after each addition. Tests in the blocks must pass. Lines that begin with "$ af2"
in ```console blocks are run, in one folder for each page; "# exit code 3" at the end says what is expected.
The lines that follow must be among what the command prints, in their order, each as a part of one; "..."
stands for anything, and so does every time in seconds.

A block of another language with the name of a file, "```json sizes.json", is that file for the commands below it. Of other
blocks, JSON is read; lines that begin with "./af2" or "af2" are run if they ask for a model of examples/, except for those that
go on until they are stopped; all other lines of shells must be sound for bash, and the scripts of the repository that they
call must have the options that they are given.

The page on the program names every option that --help does."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

PROGRAM, SOURCE = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path.insert(0, str(SOURCE / "docs" / "site"))
sys.dont_write_bytecode = True
from doc_blocks import FENCE, completed

FILE_NAME = re.compile(r"[\w-]+\.\w+")
failures = []


def run(*arguments, folder=None):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, cwd=folder, timeout=300)


def has_cad():
    return json.loads(run("version", "--json").stdout)["opencascade"]


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


def lacks(printed, shown):
    """The first line that is shown but was not printed."""
    left = iter(printed.splitlines())
    for line in shown:
        if line.strip() in ("", "..."):
            continue
        form = re.escape(line.strip()).replace(r"\ ", " ").replace(r"\.\.\.", ".*")
        form = re.sub(r"\d+(\\\.\d+)? s\b", "[0-9.]+ s", form)
        if not any(re.search(form, other) for other in left):
            return line
    return None


def commands(place, text, folder):
    for command, *shown in (part.splitlines() for part in re.split(r"^\$ (?=af2 )", text, flags=re.M)[1:]):
        if not has_cad() and (".step" in command or ".brep" in command):
            continue
        wanted = int(command.partition("# exit code ")[2] or 0)
        done = subprocess.run(command.replace("af2", f"'{PROGRAM}'", 1), shell=True, capture_output=True, text=True,
                              cwd=folder, timeout=600)
        if done.returncode != wanted:
            failures.append(f"{place}: exit code {done.returncode}: {command}\n{done.stdout}{done.stderr}")
        elif missing := lacks(done.stderr + done.stdout, shown):
            failures.append(f"{place}: {command}\nprints no '{missing}', but\n{done.stderr}{done.stdout}")


def without_comment(line):
    return re.sub(r"\s+#.*$", "", line)


def shell(place, text, folder):
    """Commands that a reader would type."""
    lines = re.sub(r"\\\n\s*", " ", text).splitlines()
    sound = subprocess.run(["bash", "-n"], input="\n".join(lines), capture_output=True, text=True)
    if sound.returncode != 0:
        failures.append(f"{place}: {sound.stderr}")
    for line in map(without_comment, lines):
        if re.match(r"(\./)?af2 (?!playground|lsp)", line) and re.search("examples/|\\btri/|\\.af2t|\\.vtu", line):
            commands(place, "$ " + line.removeprefix("./") + "\n", folder)
        script = re.match(r"(tests/\S+|docs/\S+|examples/\S+)", line)
        if script and not (SOURCE / script[1]).exists():
            failures.append(f"{place}: there is no {script[1]}")
        elif script and not os.access(SOURCE / script[1], os.X_OK):
            failures.append(f"{place}: {script[1]} is not executable")
        elif script and script[1].endswith(".py"):
            known = (SOURCE / script[1]).read_text(encoding="utf-8")
            failures.extend(f"{place}: {script[1]} has no option {option}"
                            for option in re.findall(r" (--[a-z0-9-]+)", line) if f'"{option}"' not in known)


def other_block(place, language, name, body, folder):
    if FILE_NAME.fullmatch(name):
        (pathlib.Path(folder) / name).write_text(body, encoding="utf-8")
    if language == "json":
        try:
            json.loads(body)
        except ValueError as error:
            failures.append(f"{place}: {error}")
    looks_like_shell = re.match(r"(\./|af2 |cmake |tests/|build/|gmsh |netgen |apt|ninja |cd )", body)
    if language in ("sh", "bash") or language == "" and looks_like_shell:
        shell(place, body, folder)


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
            if language not in ("af2", "cpp", "console") and page.name != "README.md":  # that has a test of its own
                other_block(place, language, info, body, folder)
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


def options_without_words():
    """Those that `af2 VERB --help` lists, by their first long name, and the page on the program does not, or whose
    value has another name there. That of an option without a word for its value is the name of a type."""
    page = (SOURCE / "docs" / "command-line.md").read_text(encoding="utf-8")
    verbs = re.findall(r"^  (\S+) ", run("--help").stdout.partition("Verbs:")[2], re.M)
    for verb in verbs:
        for option, value in re.findall(r"^  (?:-\w,)?(--[a-z-]+)\S*(?: ([A-Z]\S*))?", run(verb, "--help").stdout, re.M):
            if option != "--help" and not re.search(re.escape(option) + r"\b", page):
                failures.append(f"docs/command-line.md: af2 {verb} has an option {option}")
            if re.match("TEXT|INT|UINT|FLOAT|BOOLEAN", value) and option not in ("--filter", "--title"):
                failures.append(f"af2 {verb} --help: the value of {option} is a {value}")
            told = re.search(rf"`(?:-\w, )?{option} ([A-Z][A-Z=]*)`", page.partition(f"`af2 {verb} ")[2])
            if told and told[1] != value.partition("=tri")[0]:
                failures.append(f"docs/command-line.md: {option} {told[1]} is {value} in af2 {verb} --help")
    return len(verbs)


def unknown_options_of_gmsh():
    """Those that the page for its users names, and the program, if it is there, does not."""
    if not shutil.which("gmsh"):
        return
    known = subprocess.run(["gmsh", "-help"], capture_output=True, text=True)
    known = set(re.findall(r"(?<![\w-])-[a-z_A-Z0-9]+", known.stdout + known.stderr))
    page = (SOURCE / "docs" / "coming-from-gmsh.md").read_text(encoding="utf-8")
    named = re.findall(r"^\| (`-[^|]*) \|", page, re.M) + re.findall(r"^gmsh .*$", page, re.M)
    options = set(re.findall(r"(?<=[` ])-[a-z_0-9]+", " ".join(named)))
    failures.extend(f"docs/coming-from-gmsh.md: gmsh has no option {option}" for option in sorted(options - known))
    if len(options) < 15:
        failures.append(f"docs/coming-from-gmsh.md names only {len(options)} options of gmsh")


unknown_options_of_gmsh()
if options_without_words() < 10:
    failures.append("af2 --help lists no verbs")
pages = ([pathlib.Path(page).resolve() for page in sys.argv[3:]]
         or [SOURCE / "README.md", *sorted((SOURCE / "docs").glob("*.md"))])
total = sum(examine(page) for page in pages)
print("\n".join(failures) if failures else f"all {total} examples are sound")
sys.exit(1 if failures or (total == 0 and len(sys.argv) == 3) else 0)
