"""playground_local.py PROGRAM SOURCE BUILD: the playground of the site, WebAssembly in a browser, from a folder without a
server, gives the same meshes as the program, finds the same faults, and follows what one types.

Exits with 77 if it has not been made (cli/playground/wasm/build) or if Chromium is not installed."""

import json
import os
import pathlib
import sys
import tempfile

for folder in ("page", "playground"):
    sys.path.insert(0, str(pathlib.Path(__file__).parent / folder))
import browser
from program import Playground

PROGRAM, SOURCE, BUILD = (os.path.abspath(path) for path in sys.argv[1:4])
PAGE = pathlib.Path(BUILD) / "playground" / "page.html"
if not PAGE.exists() or not browser.program():
    print("no playground for the site, or no chromium")
    sys.exit(77)

FAULTY = 'af2 1;\nruleset "x" { elements tri; }\nrule "r" quality 1 {\n  at c (0.5, 0.866);\n  zone a, b, c;\n  tri a b d;\n}\n'
# All that says something about a mesh; pictures have all coordinates. Means are sums in another order of instructions.
KEPT = ("elements", "triangles", "quads", "withoutRule", "svg", "fault", "notes", "makers")


def ask(tab, kind, text, **parameters):
    query = "&".join(f"{name}={value}" for name, value in parameters.items())
    script = f"fetch('{kind}?{query}', {{body: {json.dumps(text)}}}).then(answer => answer.json())"
    return tab.run(script)


def open_page(tab, rules):
    tab.messages.clear()
    tab.requests.clear()
    tab.call("Page.navigate", url=f"{PAGE.as_uri()}?file={rules}")
    tab.wait_for("typeof playground !== 'undefined' && playground.isIdle")


def same_as_program(tab, rules):
    path = pathlib.Path(SOURCE) / "rules" / rules
    text = path.read_text(encoding="utf-8")
    with Playground(PROGRAM, path, "--watch") as server:
        for domain, size in (("plate", "medium"), ("star", "fine"), ("comb", "finest")):
            asked = {"domain": domain, "size": size, "color": "rule", "optimize": 1}
            native, here = server.answer("mesh", text, **asked), ask(tab, "mesh", text, **asked)
            for name in KEPT:
                assert native.get(name) == here.get(name), f"{rules}, {domain}, {size}: {name} differs"
            assert all(abs(value - here["quality"][name]) < 1e-9 for name, value in native["quality"].items()), here
        tests = [[(test["title"], test["passed"]) for test in answer["tests"]]
                 for answer in (server.answer("tests", text), ask(tab, "tests", text))]
        assert tests[0] == tests[1], f"{rules}: tests differ"


def same_faults(tab):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "x.af2"
        path.write_text(FAULTY)
        with Playground(PROGRAM, path) as server:
            found = [[(d["code"], d["range"]) for d in answer["diagnostics"]]
                     for answer in (server.answer("diagnostics", FAULTY), ask(tab, "diagnostics", FAULTY))]
    assert found[0] == found[1] and found[0], found


def follows_typing(tab):
    summary = "document.getElementById('mesh-summary').textContent"
    before = tab.run(summary)
    tab.run("playground.editor.replace(playground.text.replace('elements tri;', 'elements tri; nonsense'))")
    tab.wait_for("document.querySelector('.cm-lintRange-error') !== null")
    tab.run("playground.editor.replace(playground.text.replace(' nonsense', '').replace('0.2^2', '0.6^2'))")
    tab.wait_for(f"{summary} !== {before!r} && playground.isIdle")


def main():
    tab = browser.Browser(1280, 900)
    for rules in ("tri/even.af2", "quad/rows.af2", "quad/paving.af2"):
        open_page(tab, rules)
        same_as_program(tab, rules)
    same_faults(tab)
    open_page(tab, "tri/even.af2")
    follows_typing(tab)
    assert not tab.messages, tab.messages[:3]
    elsewhere = [r for r in tab.requests if not r.startswith(("file:", "blob:", "data:"))]
    assert not elsewhere, elsewhere[:3]
    print("the playground of the site agrees with the program")


main()
