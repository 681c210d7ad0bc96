"""Puts the playground for the site together: assemble.py PROGRAM.wasm PAGE FOLDER.

PAGE is the folder of the page that `af2 playground` serves. The same page runs in FOLDER without a server: scripts that stand
before its own answer what it asks. The program is within a script, because a page that is read from a folder may not load
it otherwise."""

import base64
import pathlib
import shutil
import sys

PROGRAM, PAGE, FOLDER = (pathlib.Path(path) for path in sys.argv[1:4])
HERE = pathlib.Path(__file__).parent

shutil.rmtree(FOLDER, ignore_errors=True)
shutil.copytree(PAGE, FOLDER, ignore=shutil.ignore_patterns("*.sh", "used.js", "README.md"))
code = base64.b64encode(PROGRAM.read_bytes()).decode("ascii")
(FOLDER / "program.js").write_text(f'"use strict";\nconst programCode = "{code}";\n')
for script in ("worker.js", "local.js"):
    shutil.copy(HERE / script, FOLDER)
page = (FOLDER / "page.html").read_text(encoding="utf-8")
own = '<script src="main.js" defer></script>'
if own not in page:
    sys.exit(f"{PAGE}/page.html does not load main.js")
scripts = "".join(f'<script src="{name}.js" defer></script>\n' for name in ("program", "worker", "local"))
(FOLDER / "page.html").write_text(page.replace(own, scripts + own), encoding="utf-8")
print(f"wrote {FOLDER / 'page.html'}")
