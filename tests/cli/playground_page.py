"""playground_page.py PROGRAM SOURCE [FOLDER]: the page of `af2 playground` in a browser, without errors or network.

With FOLDER, it leaves pictures of the page there. Exits with 77 if Chromium is not installed."""

import os
import pathlib
import subprocess
import sys
import tempfile

for folder in ("page", "playground"):
    sys.path.insert(0, str(pathlib.Path(__file__).parent / folder))
import browser
from program import Playground

PROGRAM = os.path.abspath(sys.argv[1])
PICTURES = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else None
if not browser.program():
    print("no chromium")
    sys.exit(77)


def open_page(page, server):
    page.call("Page.navigate", url="about:blank")
    page.wait_for("location.href === 'about:blank'")
    page.messages.clear()
    page.requests.clear()
    page.call("Page.navigate", url=server.address)
    settle(page)


def settle(page):
    """Waits until all answers about the text are shown."""
    page.wait_for("typeof playground !== 'undefined' && playground.isIdle")


def picture(page, name):
    if PICTURES:
        page.screenshot(PICTURES / f"{name}.png")


def text(page, identifier):
    return page.run(f"document.getElementById({identifier!r}).innerText")


def put_cursor_behind(page, words):
    page.run(f"""(() => {{
      const {{ view }} = playground.editor, at = view.state.doc.toString().indexOf({words!r}) + {len(words)};
      view.dispatch({{ selection: {{ anchor: at }}, scrollIntoView: true }});
      view.focus();
    }})()""")


def retype(page, words, others):
    """Selects some words, and types others in their place."""
    put_cursor_behind(page, words)
    page.run(f"""(() => {{
      const {{ view }} = playground.editor, {{ head }} = view.state.selection.main;
      view.dispatch({{ selection: {{ anchor: head - {len(words)}, head }} }});
    }})()""")
    type_text(page, others)


def type_text(page, words):
    for letter in words:
        page.call("Input.dispatchKeyEvent", type="keyDown", text=letter, key=letter)
        page.call("Input.dispatchKeyEvent", type="keyUp", key=letter)


def press(page, key, code, modifiers=0):
    for kind in ("rawKeyDown", "keyUp"):
        page.call("Input.dispatchKeyEvent", type=kind, key=key, code=key if len(key) > 1 else f"Key{key.upper()}",
                  windowsVirtualKeyCode=code, modifiers=modifiers)


def save_key(page):
    press(page, "s", 83, modifiers=2)


def choose(page, identifier, value):
    page.run(f"""(() => {{
      const control = document.getElementById({identifier!r});
      control.value = {value!r};
      control.dispatchEvent(new Event("change", {{ bubbles: true }}));
    }})()""")


MESH = "document.getElementById('mesh-picture').src"
HAS_MESH = """(() => { const image = document.getElementById('mesh-picture');
  return image.complete && image.naturalWidth === 1000 && image.clientWidth > 100; })()"""


def check_first_sight(page):
    assert text(page, "name") == "mine.af2" and text(page, "state") == "saved"
    assert page.run(HAS_MESH), "no mesh"
    assert "triangles" in text(page, "mesh-summary") and "all made by rules" in text(page, "mesh-summary")
    assert "3 passed, 0 failed" in text(page, "test-summary")
    assert page.run("[...document.querySelectorAll('figure img')].every(image => image.naturalWidth > 0)")
    assert page.run("document.querySelectorAll('figure').length") == 5
    picture(page, "light")


def check_fault(page):
    """A fault while one types: marked in the text, listed, and gone once it is corrected."""
    mesh = page.run(MESH)
    retype(page, "tri  a b c", "tri  a b d")
    page.wait_for("document.querySelector('.cm-lintRange-error') !== null")
    settle(page)
    assert "vertex 'd'" in text(page, "problem-list") and "1 error" in text(page, "problem-count")
    assert page.run("document.getElementById('mesh-result').classList.contains('stale')")
    assert page.run(MESH) == mesh and text(page, "mesh-fault").startswith("Line 24: ")
    assert text(page, "state") == "not saved"
    picture(page, "fault")
    page.run("document.querySelector('#problem-list button').click()")
    assert page.run("playground.editor.view.state.doc.lineAt(playground.editor.view.state.selection.main.head).number") == 24

    retype(page, "tri  a b d", "tri  a b c")
    page.wait_for(f"{MESH} !== {mesh!r} && {HAS_MESH}")
    settle(page)
    assert page.run("document.querySelector('.cm-lintRange-error') === null") and text(page, "problem-count") == "none"
    assert text(page, "state") == "saved", "the text is that of the file again"


def check_mesh(page):
    before = text(page, "mesh-summary")
    choose(page, "domain", "comb")
    page.wait_for(f"document.getElementById('mesh-summary').innerText !== {before!r}")
    assert "closing" in text(page, "makers") or "all made by rules" in text(page, "mesh-summary")
    choose(page, "color", "quality")
    page.wait_for("!document.getElementById('quality-legend').hidden")
    choose(page, "color", "rule")
    choose(page, "domain", "plate")
    page.wait_for(f"document.getElementById('mesh-summary').innerText === {before!r} && {HAS_MESH}")
    page.run("document.querySelector('#makers button').click()")
    assert page.run("document.activeElement.classList.contains('cm-content')"), "a rule of the mesh leads to its text"


def check_failing_test(page):
    retype(page, 'expect rule "right', 'expect rule "left')
    page.wait_for("document.querySelector('#failed-tests pre') !== null")
    settle(page)
    assert "1 failed" in text(page, "test-summary") and 'expected rule "left"' in text(page, "failed-tests")
    picture(page, "failing test")
    retype(page, 'expect rule "left', 'expect rule "right')
    page.wait_for("document.querySelector('#failed-tests pre') === null")
    settle(page)


def check_completion(page):
    put_cursor_behind(page, "tri  a b c;")
    press(page, "Enter", 13)
    type_text(page, "zo")
    page.wait_for("[...document.querySelectorAll('.cm-completionLabel')].some(item => item.textContent === 'zone')")
    press(page, "Escape", 27)
    for _ in range(8):
        press(page, "z", 90, modifiers=2)
    page.wait_for("playground.text === playground.saved")


def check_save(page, path):
    put_cursor_behind(page, "af2 1;")
    type_text(page, " # mine")
    save_key(page)
    page.wait_for("document.getElementById('state').innerText === 'saved'")
    saved = path.read_text()
    assert saved.startswith("af2 1; # mine\n"), saved[:40]

    # Without changes of one's own, the page follows the file; otherwise it asks.
    path.write_text(saved.replace("# mine", "# theirs"))
    page.wait_for("playground.editor.text().startsWith('af2 1; # theirs')")
    put_cursor_behind(page, "# theirs")
    type_text(page, " and mine")
    path.write_text(saved)
    page.wait_for("!document.getElementById('notice').hidden")
    assert "Another program has changed the file." in text(page, "notice")
    save_key(page)
    page.wait_for("document.getElementById('notice').innerText.startsWith('Not saved')")
    assert path.read_text() == saved
    picture(page, "changed on disk")
    page.run("[...document.querySelectorAll('#notice button')].find(b => b.textContent === 'Overwrite it').click()")
    page.wait_for("document.getElementById('state').innerText === 'saved'")
    assert path.read_text() == page.run("playground.editor.text()") != saved
    settle(page)


def check_layout(page):
    unnamed = page.run("""[...document.querySelectorAll('button, input, select')].filter(control =>
      !control.ariaLabel && !control.labels?.length && !control.textContent.trim() && !control.title)
      .map(control => control.outerHTML)""")
    assert unnamed == [], unnamed
    color = "getComputedStyle(document.body).backgroundColor"
    for width in (360, 700, 1400):
        page.resize(width, 900)
        assert page.run("document.documentElement.scrollWidth <= innerWidth"), width
        picture(page, f"light {width}")
    light = page.run(color)
    page.run("document.getElementById('scheme').click()")
    assert page.run(color) != light
    for width in (700, 1400):
        page.resize(width, 900)
        picture(page, f"dark {width}")
    page.run("document.getElementById('scheme').click()")


def check_watch(page, path):
    with Playground(PROGRAM, path, "--watch") as server:
        open_page(page, server)
        assert page.run("document.querySelector('.cm-editor') === null && document.getElementById('save').hidden")
        before = page.run(MESH)
        path.write_text(path.read_text().replace('  mirror "left";\n', ""))
        page.wait_for("document.querySelectorAll('figure').length === 4")
        page.wait_for(f"{MESH} !== {before!r} && {HAS_MESH}")
        picture(page, "watch")
        check_quiet(page, server)
        server.process.terminate()
        page.wait_for("document.getElementById('notice').innerText.startsWith('The program does not answer')")


def check_quiet(page, server):
    assert page.messages == [], page.messages
    own = (server.address, f"blob:http://127.0.0.1:{server.port}/", "data:")
    others = [request for request in page.requests if not request.startswith(own)]
    assert others == [], others


def main():
    with tempfile.TemporaryDirectory() as folder, browser.Browser(1400, 900) as page:
        path = pathlib.Path(folder) / "mine.af2"
        subprocess.run([PROGRAM, "new", "ruleset", path], check=True, stdout=subprocess.DEVNULL)
        page.prefer("light")
        with Playground(PROGRAM, path) as server:
            open_page(page, server)
            check_first_sight(page)
            for check in (check_fault, check_mesh, check_failing_test, check_completion):
                check(page)
                check_quiet(page, server)
            check_save(page, path)
            check_layout(page)
            check_quiet(page, server)
        check_watch(page, path)


main()
