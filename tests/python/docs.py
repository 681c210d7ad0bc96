"""Runs the Python code of docs/python.md and README.md: docs.py SOURCE.

The blocks fenced as ```python of a page run one after the other, in one namespace and in a folder with the models of the
examples. "```python raises InputError" must raise that error, and "```python needs meshio" is left out without it."""

import importlib.util
import os
import pathlib
import re
import shutil
import sys
import tempfile

import af2

SOURCE = pathlib.Path(sys.argv[1])
FENCE = re.compile(r"^```python([^\n]*)\n(.*?)^```$", re.M | re.S)
failures = []
ran = 0
for page in ("docs/python.md", "README.md"):
    text = (SOURCE / page).read_text(encoding="utf-8")
    space = {"__name__": "__main__"}
    with tempfile.TemporaryDirectory() as folder:
        for model in (SOURCE / "examples" / "models").iterdir():
            shutil.copy(model, folder)
        os.chdir(folder)
        for match in FENCE.finditer(text):
            what, code = match.group(1).split(), match.group(2)
            line = text[: match.start()].count("\n") + 1
            if what[:1] == ["needs"] and importlib.util.find_spec(what[1]) is None:
                continue
            ran += 1
            try:
                exec(compile("\n" * line + code, page, "exec"), space)
                if what[:1] == ["raises"]:
                    failures.append(f"{page}:{line}: nothing was raised")
            except Exception as error:
                if what != ["raises", type(error).__name__]:
                    failures.append(f"{page}:{line}: {type(error).__name__}: {error}")
        os.chdir(SOURCE)
print("\n".join(failures) or f"{ran} blocks")
sys.exit(1 if failures or ran < 10 else 0)
