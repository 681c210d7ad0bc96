"""trace_pages.py PROGRAM SOURCE: pages that `af2 trace view` writes work in a browser, without errors or network.

Exits with 77 if Chromium is not installed."""

import os
import pathlib
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent / "page"))
import browser

PROGRAM, SOURCE = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
MODELS = SOURCE / "examples/models"
MOST_SECONDS = 90  # until, on a busy machine, a page with 20,000 charts can be used
if not browser.program():
    print("no chromium")
    sys.exit(77)


def af2(*arguments):
    run = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    assert run.returncode == 0, (arguments, run.stderr)
    return run.stdout


def page_of(folder, name, model, *options, view=()):
    trace, path = f"{folder}/{name}.af2t", f"{folder}/{name}.html"
    af2("mesh", MODELS / model, *options, "--trace", trace, "-q")
    return path, af2("trace", "view", trace, "-o", path, *view)


def click(page, identifier):
    page.run(f"document.getElementById({identifier!r}).click()")


def text(page, identifier):
    return page.run(f"document.getElementById({identifier!r}).innerText")


def event(page):
    return page.run("af2.page.event")


def check_quiet(page, path):
    assert page.messages == [], page.messages
    assert page.requests == ["file://" + path], page.requests


def check_steps(page):
    """Forward and back; the table and the chart tell the same rule as the caption."""
    assert event(page) == 0
    click(page, "forward")
    click(page, "forward")
    assert event(page) == 2
    assert "step 3:" in text(page, "caption"), text(page, "caption")
    elements = int(text(page, "shown").split()[0])
    assert elements >= 3, elements
    rule = page.run("af2.run.rules[af2.run.rule[2]].name")
    assert page.run("document.querySelector('#reasons tr.applied button').textContent") == rule
    assert page.run("document.querySelectorAll('#chart .made').length") == page.run(
        "af2.run.rules[af2.run.rule[2]].elements.length")
    assert page.run("document.querySelector('#chart .zone') !== null")
    assert rule in text(page, "rule-text") or rule.rstrip("0123456789 ") in text(page, "rule-text")
    click(page, "back")
    assert event(page) == 1 and int(text(page, "shown").split()[0]) < elements


def check_refusal(page):
    """The next refusal names why, and marks what hit the zone."""
    click(page, "next-refusal")
    assert "no rule" in text(page, "caption"), text(page, "caption")
    assert page.run("document.querySelector('#reasons tr.applied')") is None
    for _ in range(200):
        if "zone hit by vertex" in text(page, "reasons"):
            break
        click(page, "next-refusal")
    assert "lies in the zone" in text(page, "reasons"), text(page, "reasons")
    page.run("""[...document.querySelectorAll('#reasons tr')].find(row => row.textContent.includes('zone hit by vertex'))
      .querySelector('button').click()""")
    assert page.run("document.querySelector('#chart .hit-vertex') !== null"), "the culprit is not marked"
    assert page.run("document.querySelectorAll('#chart text').length") >= 3


def check_uses(page):
    """The next use of a rule, by the list and by the table."""
    rule = page.run("document.getElementById('rule-choice').value")
    before = event(page)
    click(page, "next-use")
    assert event(page) > before and page.run(f"af2.run.rule[af2.page.event]") == int(rule)
    after = event(page)
    click(page, "rule-next")
    assert event(page) > after and page.run(f"af2.run.rule[af2.page.event]") == int(rule)
    click(page, "rule-previous")
    assert event(page) == after
    click(page, "next-loop")
    assert event(page) > after and page.run("af2.page.closesLoop(af2.page.event)")


def check_click(page):
    """A click on an element shows the step that made it."""
    page.run("af2.page.seek(af2.run.lastEvent)")
    box = page.run("""(() => {
      const b = canvas.getBoundingClientRect(), p = af2.view.mesh.positions, corners = cornersOf(af2.view.mesh, 5);
      const middle = new THREE.Vector3();
      for (const v of corners) middle.add(new THREE.Vector3(p[3 * v], p[3 * v + 1], p[3 * v + 2]).divideScalar(3));
      middle.project(af2.view.camera);
      return [b.left + (middle.x + 1) / 2 * b.width, b.top + (1 - middle.y) / 2 * b.height];
    })()""")
    element = page.run(f"""(() => {{
      const b = canvas.getBoundingClientRect();
      return elementAlong(af2.view, rayAt(af2.view.camera, 2 * ({box[0]} - b.left) / b.width - 1, 1 - 2 * ({box[1]} - b.top) / b.height));
    }})()""")
    assert element >= 0
    page.click(*box)
    assert event(page) == page.run(f"af2.run.birth[{element}]"), "another step is shown"


def check_changes(page):
    """The changes after the front can be stepped through, and taken back exactly."""
    page.run("af2.page.seek(0)")
    before = page.run("Array.from(af2.run.mesh.positions)")
    click(page, "next-change")
    caption = text(page, "caption")
    assert "after the front" in caption or "turned round" in caption, caption
    assert page.run("af2.page.surface.before.visible || af2.page.surface.after.visible")
    page.run("af2.page.seek(af2.run.lastEvent)")
    assert page.run("Array.from(af2.run.mesh.positions)") != before, "no vertex moved"
    elements = int(text(page, "shown").split()[0].replace(",", ""))
    page.run("af2.page.seek(0)")
    assert page.run("Array.from(af2.run.mesh.positions)") == before, "moves are not taken back"
    return elements


def check_rows(page):
    """The smoothing of a row is shown between the steps, with the front around it."""
    row = page.run("af2.run.kind.indexOf(eventKinds.row)")
    assert row > 0, "no row"
    page.run(f"af2.page.seek({row})")
    assert "a row is complete" in text(page, "caption"), text(page, "caption")
    assert page.run("af2.page.surface.front.visible && af2.page.surface.after.visible")
    assert page.run("af2.run.rules.findIndex((rule) => rule.name === 'seam') >= 0")


def check_play(page):
    """Plays until it is paused, and ends at the last event."""
    page.run("af2.page.seek(0)")
    page.run("document.getElementById('follow').click()")
    click(page, "play")
    page.wait_for("af2.page.event > 3")
    click(page, "play")
    at = event(page)
    page.run("new Promise(done => setTimeout(done, 300))")
    assert event(page) == at, "it plays on after a pause"
    assert page.run("af2.view.camera.zoom > 1"), "it does not follow"
    page.run("document.getElementById('follow').click()")
    page.run("af2.view.look(af2.view.direction())")
    page.run("af2.page.seek(af2.run.lastEvent - 2)")
    click(page, "play")
    page.wait_for("!af2.page.isPlaying")
    assert event(page) == page.run("af2.run.lastEvent")


def check_scheme(page):
    picture = "document.getElementById('timeline').toDataURL()"
    light = page.run(picture)
    click(page, "scheme")
    assert page.run(picture) != light, "the time line keeps its colours"
    click(page, "scheme")
    assert page.run(picture) == light


def check_timeline(page):
    box = page.run("(() => { const b = timeline.getBoundingClientRect(); return [b.left, b.top, b.width, b.height]; })()")
    page.click(box[0] + box[2] - 2, box[1] + box[3] / 2)
    assert event(page) >= 0.98 * page.run("af2.run.lastEvent"), event(page)


def check_names(page):
    unnamed = page.run("""[...document.querySelectorAll('button, input, select')].filter(control =>
      !control.ariaLabel && !control.labels?.length && !control.textContent.trim() && !control.title)
      .map(control => control.outerHTML)""")
    assert unnamed == [], unnamed
    for width in (360, 900, 1600):
        page.resize(width, 800)
        assert page.run("document.documentElement.scrollWidth <= innerWidth"), width
    page.resize(1280, 800)


def main():
    with tempfile.TemporaryDirectory() as folder, browser.Browser() as page:
        page.prefer("light")
        path, _ = page_of(folder, "plate", "plate.poly", "--size", "0.5")
        page.open(path)
        for check in (check_steps, check_refusal, check_uses, check_click, check_play, check_scheme, check_timeline, check_names):
            check(page)
            check_quiet(page, path)
        shown = check_changes(page)
        af2("mesh", MODELS / "plate.poly", "--size", "0.5", "-o", f"{folder}/plate.obj", "-q")
        made = sum(line.startswith("f ") for line in open(f"{folder}/plate.obj"))
        assert shown == made, f"the page ends with {shown} elements, the mesh has {made}"
        check_quiet(page, path)

        # Rows that are smoothed, elements that are turned round: nothing is missing.
        path, _ = page_of(folder, "paved", "plate.poly", "--size", "0.25", "-r", "quad/paving", "--elements", "quad")
        page.open(path)
        assert text(page, "notes-list") == "", text(page, "notes-list")
        check_rows(page)
        shown = check_changes(page)
        af2("mesh", MODELS / "plate.poly", "--size", "0.25", "-r", "quad/paving", "--elements", "quad", "-o",
            f"{folder}/paved.obj", "-q")
        made = sum(line.startswith("f ") for line in open(f"{folder}/paved.obj"))
        assert shown == made, f"the page ends with {shown} elements, the mesh has {made}"
        check_quiet(page, path)

        # Only some steps, of one face of several, with quadrilaterals.
        path, _ = page_of(folder, "brick", "brickhole.step", "--size", "1", "-r", "quad/rows.af2",
                          view=("--face", "2", "--from", "5", "--to", "20"))
        page.open(path)
        assert "step 5:" in text(page, "caption"), text(page, "caption")
        click(page, "last")
        assert "step 20:" in text(page, "caption"), text(page, "caption")
        check_quiet(page, path)

        # As many charts as a page has by default.
        path, said = page_of(folder, "die", "die.step", "--size", "0.6")
        assert "charts of 20000 of the" in said, said
        began = time.monotonic()
        page.open(path)
        click(page, "next-refusal")
        assert text(page, "reasons") != ""
        seconds = time.monotonic() - began
        assert seconds < MOST_SECONDS, seconds
        page.run("af2.page.seek(af2.run.lastEvent)")
        assert "20000" in text(page, "notes-list")
        assert "no chart" in text(page, "reasons") or "after the front" in text(page, "caption")
        check_quiet(page, path)
        print(f"20,000 charts: {os.path.getsize(path) / 1e6:.0f} MB, shown after {seconds:.1f} s")


main()
