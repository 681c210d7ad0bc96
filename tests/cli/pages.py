"""pages.py PROGRAM SOURCE: pages that `af2 mesh -o part.html` writes work in a browser, without errors or network.

Exits with 77 if Chromium is not installed."""

import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent / "page"))
import browser

PROGRAM, SOURCE = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
MODELS = SOURCE / "examples/models"
if not browser.program():
    print("no chromium")
    sys.exit(77)

# Reads the drawing buffer after a fresh picture: how many pixels were drawn, and a sum that colours change.
PICTURE = """(() => {
  af2.view.drawNow();
  const gl = af2.view.renderer.getContext(), width = gl.drawingBufferWidth, height = gl.drawingBufferHeight;
  const bytes = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  let drawn = 0, sum = 0, red = 0;
  for (let i = 0; i < bytes.length; i += 4) {
    if (bytes[i + 3] > 0) ++drawn;
    sum = (sum * 31 + bytes[i] + 256 * bytes[i + 1] + 65536 * bytes[i + 2]) % 1000003;
    if (bytes[i] > 180 && bytes[i + 1] < 90 && bytes[i + 2] < 90 && bytes[i + 3] > 0) ++red;
  }
  return { drawn, sum, red, pixels: width * height };
})()"""


def mesh(model, output, *options):
    run = subprocess.run([PROGRAM, "mesh", str(model), "-o", output, "-q", *options], capture_output=True, text=True)
    assert run.returncode in (0, 3), run.stderr
    return run.returncode


def choose(page, identifier, value):
    """Sets a control and tells the page, as a user would."""
    page.run(f"""(() => {{
      const control = document.getElementById({identifier!r});
      control.value = {value!r};
      for (const kind of ["input", "change"]) control.dispatchEvent(new Event(kind, {{ bubbles: true }}));
    }})()""")


def text(page, identifier):
    return page.run(f"document.getElementById({identifier!r}).innerText")


def check_quiet(page, path):
    assert page.messages == [], page.messages
    assert page.requests == ["file://" + path], page.requests


def check_colors(page):
    plain = page.run(PICTURE)
    assert 0.15 * plain["pixels"] < plain["drawn"] < 0.9 * plain["pixels"], plain
    seen = {plain["sum"]}
    for key in page.run("[...document.getElementById('color-by').options].map(o => o.value)"):
        choose(page, "color-by", key)
        picture = page.run(PICTURE)
        assert picture["drawn"] == plain["drawn"], (key, picture, plain)
        seen.add(picture["sum"])
        assert text(page, "legend") != "", key
    assert len(seen) >= 6, "colours do not change"
    choose(page, "color-by", "quality")
    assert page.run(PICTURE) == plain
    page.run("document.getElementById('stretch').click()")
    assert page.run(PICTURE)["sum"] != plain["sum"], "colours are not spread"
    page.run("document.getElementById('stretch').click()")
    assert page.run(PICTURE) == plain


def check_element(page):
    """A click in the middle of the picture, and the same element by its number."""
    box = page.run("(() => { const b = canvas.getBoundingClientRect(); return [b.left + b.width / 2, b.top + b.height / 2]; })()")
    page.click(*box)
    card = text(page, "element-card")
    for word in ("Element", "Corners", "Face", "Surface", "Chart", "Rule", "Level", "Score", "Quality", "Angles"):
        assert word in card, (word, card)
    number = page.run("document.getElementById('element-number').value")
    quality = page.run(f"String(Number(af2.mesh.quality[{number}].toPrecision(5)))")
    assert quality in card, (quality, card)
    page.click(box[0], 5)  # beside the mesh
    assert text(page, "element-card") == ""

    made_by_rule = page.run("af2.mesh.rule.findIndex(rule => rule >= 0 && af2.mesh.rules[rule].text)")
    choose(page, "element-number", str(made_by_rule))
    page.run("document.getElementById('element-form').requestSubmit()")
    title = page.run(f"af2.mesh.rules[af2.mesh.rule[{made_by_rule}]].name")
    assert title in text(page, "element-card")
    place, rule = text(page, "rule-place"), text(page, "rule-text")
    file, line = place.rsplit(":", 1)
    assert file.startswith("tri/"), place
    lines = (SOURCE / "rules" / file).read_text().splitlines()
    assert lines[int(line) - 1].startswith("rule "), (place, lines[int(line) - 1])
    assert rule.splitlines() == lines[int(line) - 1:int(line) - 1 + len(rule.splitlines())], rule
    page.run("document.getElementById('element-clear').click()")
    assert text(page, "element-card") == ""


def shown(page):
    return int(text(page, "shown").split()[0].replace(",", ""))


def check_filter(page):
    every, before = shown(page), page.run(PICTURE)
    assert every == page.run("af2.mesh.elementCount")
    choose(page, "lowest", 200)
    filtered = shown(page)
    low = page.run("af2.page.histogram.limits()[0]")
    assert filtered == page.run(f"af2.mesh.quality.filter(q => q >= {low}).length") < every, filtered
    assert page.run(PICTURE)["drawn"] < before["drawn"]
    page.run("document.getElementById('filter-reset').click()")
    assert shown(page) == every and page.run(PICTURE) == before
    page.run("document.getElementById('lowest').focus()")
    page.press("ArrowRight")
    assert text(page, "range") != "", "no range"
    page.run("document.getElementById('filter-reset').click()")


def check_section(page):
    before = page.run(PICTURE)
    page.run("document.querySelector('input[name=axis][value=z]').click()")
    half = page.run(PICTURE)
    page.run("document.getElementById('flip').click()")
    other = page.run(PICTURE)
    assert half["drawn"] < before["drawn"] and half["sum"] != other["sum"], (before, half, other)
    page.run("document.querySelector('input[name=axis][value=none]').click()")
    assert page.run(PICTURE) == before


def check_faces(page):
    page.run("document.querySelector('#faces input').click()")
    assert shown(page) == page.run("af2.mesh.elementCount - af2.mesh.faces[0].elements")
    page.run("document.querySelector('#faces button').click()")  # only
    assert shown(page) == page.run("af2.mesh.faces[0].elements")
    page.run("document.getElementById('faces-all').click()")
    assert shown(page) == page.run("af2.mesh.elementCount")
    if page.run("document.querySelector('#groups input') !== null"):
        page.run("document.querySelector('#groups input').click()")
        assert shown(page) < page.run("af2.mesh.elementCount")
        page.run("document.querySelector('#groups input').click()")


def check_names(page):
    """Every control has a name for those who do not see it, and text does not run out of the window."""
    unnamed = page.run("""[...document.querySelectorAll('button, input, select')].filter(control =>
      !control.ariaLabel && !control.labels?.length && !control.textContent.trim() && !control.title)
      .map(control => control.outerHTML)""")
    assert unnamed == [], unnamed
    for width in (360, 760, 1600):
        page.resize(width, 800)
        assert page.run("document.documentElement.scrollWidth <= innerWidth"), width
    page.resize(1280, 800)
    page.wait_for("innerWidth === 1280 && canvas.width === canvas.clientWidth && canvas.height === canvas.clientHeight")


def check_keys(page):
    before = page.run(PICTURE)
    page.run("canvas.focus()")
    page.press("ArrowRight")
    assert page.run(PICTURE)["sum"] != before["sum"]
    page.run("document.querySelector('[data-view=iso]').click()")
    assert page.run(PICTURE) == before


def check_mouse(page):
    """The mesh follows a drag with the right button; the wheel zooms; the left button turns."""
    before = page.run(PICTURE)
    at = "(() => { const p = af2.view.middle.clone().project(af2.view.camera); return [p.x, p.y]; })()"
    page.drag(400, 400, 500, 330, "right")
    x, y = page.run(at)
    width, height = page.run("[canvas.clientWidth, canvas.clientHeight]")
    assert abs(x * width / 2 - 100) < 3 and abs(y * height / 2 - 70) < 3, (x * width / 2, y * height / 2)
    zoom = page.run("af2.view.camera.zoom")
    page.call("Input.dispatchMouseEvent", type="mouseWheel", x=400, y=400, deltaX=0, deltaY=-100)
    page.wait_for(f"af2.view.camera.zoom > 1.05 * {zoom}")
    page.run("document.querySelector('[data-view=iso]').click()")
    page.drag(400, 400, 500, 400, "left")
    assert page.run("af2.view.direction().dot(isoDirection)") < 0.95
    assert text(page, "element-card") == "", "a drag is no click"
    page.run("document.querySelector('[data-view=iso]').click()")
    assert page.run(PICTURE) == before


def check_odd_numbers(page):
    """Scores can be infinite, or missing."""
    assert page.run("extent([NaN, Infinity, 1, 3])") == [1, 3]
    assert page.run("[NaN, Infinity, 0.25].map(digits)") == ["none", "infinite", "0.25"]
    page.run("""af2.page.quantities.set("odd", numericQuantity("odd", "Odd",
      Float32Array.from(af2.mesh.quality, (q, e) => [q, NaN, Infinity][e % 3]), [1, 0]))""")
    page.run("af2.page.colorBy('odd')")
    assert page.run("af2.page.histogram.bars.reduce((a, b) => a + b) + af2.page.histogram.none") == shown(page)
    assert "have none" in text(page, "range"), text(page, "range")
    choose(page, "highest", 399)
    assert shown(page) <= page.run("Math.ceil(af2.mesh.elementCount / 3)")
    choose(page, "color-by", "quality")


def check_scheme(page):
    color = "getComputedStyle(document.body).backgroundColor"
    light = page.run(color)
    page.run("document.getElementById('scheme').click()")
    assert page.run(color) != light
    page.run("document.getElementById('scheme').click()")


def check_failures(page):
    assert text(page, "failed-title") == "2 faces of 10 without a mesh", text(page, "failed-title")
    assert "stuck" in text(page, "failed-list")
    red = page.run(PICTURE)["red"]
    assert red > 20, red
    zoom = page.run("af2.view.camera.zoom")
    page.run("document.querySelector('#failed-list button').click()")
    assert page.run("af2.view.camera.zoom") > zoom
    assert page.run(PICTURE)["red"] > red
    page.run("document.querySelector('#failed-list details').open = true")
    assert "free: " in text(page, "failed-list")


def main():
    with tempfile.TemporaryDirectory() as folder, browser.Browser() as page:
        page.prefer("light")
        path = f"{folder}/die.html"
        assert mesh(MODELS / "die.step", path, "--size", "1") == 0
        page.open(path)
        for check in (check_colors, check_element, check_filter, check_section, check_faces, check_names, check_keys,
                      check_mouse, check_odd_numbers, check_scheme):
            check(page)
            check_quiet(page, path)

        path = f"{folder}/curved quads.html"
        assert mesh(MODELS / "brickhole.step", path, "--size", "2", "-r", "quad/rows.af2", "--order", "2") == 0
        page.open(path)
        corners, quads = page.run("""(() => {
          const counts = Array.from({ length: af2.mesh.elementCount }, (_, e) => cornerCount(af2.mesh, e));
          return [counts.reduce((a, b) => a + b), counts.filter(count => count === 4).length];
        })()""")
        assert quads > 0
        assert page.run("2 * af2.view.sides.count") == corners, "diagonals drawn as sides"
        assert page.run("af2.view.triangles.count - 4 * af2.mesh.elementCount") == 2 * quads
        page.requests = [request.replace("%20", " ") for request in page.requests]
        check_quiet(page, path)

        path = f"{folder}/plate.html"
        assert mesh(MODELS / "plate.poly", path, "--size", "0.5") == 0
        page.open(path)
        assert page.run("af2.view.direction().z") > 0.999, "a planar mesh is seen from above"
        check_quiet(page, path)

        path = f"{folder}/failed.html"
        rules = SOURCE / "tests/cli/page/few_rules.af2"
        assert mesh(MODELS / "brickhole.step", path, "--size", "1", "-r", rules, "--strict-rules", "--unchecked") == 3
        page.open(path)
        check_failures(page)
        check_quiet(page, path)


main()
