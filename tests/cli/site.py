"""site.py PROGRAM SOURCE BUILD [FOLDER]: the site is made, its links lead somewhere, and it reads well in a browser, wide and
narrow, light and dark, without loading anything from elsewhere.

With FOLDER, it leaves pictures of some pages there. Exits with 77 if MkDocs or Doxygen is not installed."""

import functools
import http.server
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading

PROGRAM, SOURCE, BUILD = (pathlib.Path(os.path.abspath(path)) for path in sys.argv[1:4])
PICTURES = pathlib.Path(sys.argv[4]) if len(sys.argv) > 4 else None
sys.dont_write_bytecode = True
sys.path[:0] = [str(SOURCE / "docs" / "site"), str(pathlib.Path(__file__).parent / "page")]
import browser
import check_links

PAGES = ["index", "language", "rules/tri-even", "command-line", "api/engine", "gallery", "coming-from-gmsh", "tutorial"]
# Wider than the window: none but what scrolls within itself.
OVERFLOW = "document.scrollingElement.scrollWidth - document.documentElement.clientWidth"
BRIGHTNESS = """(() => { const parts = getComputedStyle(document.body).backgroundColor.match(/[\\d.]+/g).map(Number);
  return parts[0] + parts[1] + parts[2]; })()"""
failures = []


def expect(holds, what):
    if not holds:
        failures.append(what)


def see_that_links_are_followed(site):
    """A link to nowhere, a place that is not there, and something from another server are found."""
    page = site / "releases.html"
    text = page.read_text(encoding="utf-8")
    for part in ('<a href="nowhere.html">', '<a href="index.html#nowhere">', '<img src="https://example.org/x.png">'):
        page.write_text(text + part, encoding="utf-8")
        expect(len(list(check_links.faults(site))) == 1, f"{part} is not found")
    page.write_text(text, encoding="utf-8")


def served(site):
    class Quiet(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *_):
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=str(site)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return f"http://127.0.0.1:{server.server_address[1]}/"


def look_at(tab, address, page, width, scheme):
    tab.call("Page.navigate", url=f"{address}{page}.html")
    tab.wait_for("document.readyState === 'complete' && document.querySelector('article h1') !== null")
    place = f"{page}, {width} pixels, {scheme}"
    expect(tab.run(OVERFLOW) <= 0, f"{place}: the page is {tab.run(OVERFLOW)} pixels wider than the window")
    expect((tab.run(BRIGHTNESS) < 384) == (scheme == "dark"), f"{place}: the background is {tab.run(BRIGHTNESS)}")
    broken = "[...document.images].filter(i => i.complete && i.naturalWidth === 0).map(i => i.src).join(' ')"
    expect(tab.run(broken) == "", f"{place}: pictures are broken: {tab.run(broken)}")
    if PICTURES:
        tab.screenshot(PICTURES / f"{page.replace('/', '-')}-{width}-{scheme}.png")


def look_at_all(site):
    address = served(site)
    for width, height in ((1280, 900), (390, 800)):
        for scheme in ("light", "dark"):
            tab = browser.Browser(width, height)
            tab.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
            for page in PAGES:
                look_at(tab, address, page, width, scheme)
            if width > 1000 and scheme == "light":
                search(tab, address)
            elsewhere = [r for r in tab.requests if not str(r).startswith((address, "data:", "blob:", "about:"))]
            expect(not elsewhere, f"the site asks for {elsewhere[:3]}")
            expect(not tab.messages, f"the site complains: {tab.messages[:3]}")


def search(tab, address):
    # By a link with a query, which the page follows when its search is ready: words that are typed before lose the
    # index for good where the index comes while they wait (Material 8.2, both take the one place of what waits).
    tab.call("Page.navigate", url=f"{address}index.html?q=free+zone")
    tab.wait_for("document.querySelectorAll('.md-search-result__item').length > 0")


def main():
    if not shutil.which("mkdocs") or not shutil.which("doxygen"):
        print("mkdocs or doxygen is not installed")
        return 77
    with tempfile.TemporaryDirectory() as name:
        site = pathlib.Path(name) / "site"
        made = subprocess.run([SOURCE / "docs" / "site" / "build", site, "--af2", PROGRAM, "--build", BUILD],
                              capture_output=True, text=True, check=False)
        if made.returncode != 0:
            print(made.stdout + made.stderr)
            return 1
        see_that_links_are_followed(site)
        language = (site / "language.html").read_text(encoding="utf-8")
        expect('<span class="kd">rule</span>' in language, "rules have no colours")
        expect(language.count("drawn/language-") > 10, "rules have no pictures")
        expect("MeshingOptions" in (site / "api" / "geometry.html").read_text(encoding="utf-8"), "no reference of C++")
        if browser.program():
            look_at_all(site)
    print("\n".join(failures) if failures else "the site is sound")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
