"""Runs every example of the Python package: scripts, and the code cells of notebooks, each in a folder of its own.

examples.py SOURCE. What an example writes must be there at its end, as the last line of its docstring or first cell says:
"Writes: die.vtu, die.html"."""

import json
import os
import pathlib
import re
import runpy
import sys
import tempfile
import time

SOURCE = pathlib.Path(sys.argv[1])
EXAMPLES = SOURCE / "examples" / "python"


def run_notebook(path):
    """As Jupyter does: one namespace for all cells; the last expression of a cell is shown, as HTML if it can be."""
    import ast

    space = {"__name__": "__main__"}
    for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]:
        if cell["cell_type"] != "code":
            continue
        tree = ast.parse("".join(cell["source"]))
        last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
        exec(compile(tree, path.name, "exec"), space)
        if last is not None:
            value = eval(compile(ast.Expression(last.value), path.name, "eval"), space)
            shown = value._repr_html_() if hasattr(value, "_repr_html_") else repr(value)
            assert shown


def text_of(path):
    return path.read_text(encoding="utf-8").replace("\\n", "\n")


failures = []
paths = sorted([*EXAMPLES.glob("*.py"), *EXAMPLES.glob("*.ipynb")])
assert len(paths) >= 4, "there are no examples"
for path in paths:
    os.environ["AF2_MODELS"] = str(SOURCE / "examples" / "models")
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        begin = time.monotonic()
        try:
            run_notebook(path) if path.suffix == ".ipynb" else runpy.run_path(str(path), run_name="__main__")
            for names in re.findall(r"Writes: ([^\n\"]+)", text_of(path)):
                for name in re.split(r",\s*", names.strip().rstrip(".")):
                    assert os.path.getsize(name) > 0, name
            print(f"{path.name}: {time.monotonic() - begin:.1f} s")
        except SystemExit as error:
            if error.code:
                failures.append(f"{path.name}: {error.code}")
        except Exception as error:
            failures.append(f"{path.name}: {type(error).__name__}: {error}")
        os.chdir(SOURCE)
print("\n".join(failures))
sys.exit(1 if failures else 0)
