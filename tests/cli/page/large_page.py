"""large_page.py PROGRAM [TRIANGLES]: how long a page of about a million triangles takes to load and to draw.

Meshes a square with a hole, opens its page in headless Chromium without a graphics card, and prints times. Takes a
minute, so it is no test of ./check; docs/performance.md has its figures."""

import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import browser

# Each picture ends with reading a pixel, which waits until all is drawn.
FRAMES = """(() => {
  const view = af2.view;
  const time = (draw) => { const began = performance.now(); draw(); view.waitForPicture(); return performance.now() - began; };
  const median = (draw) => {
    draw(); // the first picture sends arrays to the graphics card
    const times = Array.from({ length: 9 }, () => { view.turn(0.1, 0.03); return time(draw); }).sort((a, b) => a - b);
    return times[4];
  };
  const all = median(() => view.drawNow()), coarse = median(() => view.drawCoarse());
  view.showEdges(true);
  const edges = median(() => view.drawNow());
  view.showEdges(false);
  view.drawNow();
  const pick = time(() => elementAlong(view, rayAt(view.camera, 0.3, 0.3)));
  const color = time(() => view.setColors(af2.page.quantities.get("rule")));
  const filter = time(() => af2.page.showVisible());
  return { all, coarse, edges, pick, color, filter, start: af2.startMilliseconds,
           megabytes: performance.memory.usedJSHeapSize / 1e6, elements: af2.mesh.elementCount };
})()"""

SQUARE = "8 2 0 0\n1 0 0\n2 10 0\n3 10 10\n4 0 10\n5 4 4\n6 4 6\n7 6 6\n8 6 4\n" \
    "8 0\n1 1 2\n2 2 3\n3 3 4\n4 4 1\n5 5 6\n6 6 7\n7 7 8\n8 8 5\n1\n1 5 5\n"


def main():
    program, triangles = os.path.abspath(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else 1e6
    size = math.sqrt(96 / triangles / (math.sqrt(3) / 4))
    with tempfile.TemporaryDirectory() as folder:
        model, path = f"{folder}/square.poly", f"{folder}/square.html"
        pathlib.Path(model).write_text(SQUARE)
        began = time.monotonic()
        subprocess.run([program, "mesh", model, "--size", str(size), "-o", path, "-q"], check=True)
        print(f"mesh and page written in {time.monotonic() - began:.1f} s, {os.path.getsize(path) / 1e6:.0f} MB")
        with browser.Browser() as page:
            began = time.monotonic()
            page.open(path)
            opened = time.monotonic() - began
            times = page.run(FRAMES)
            assert page.messages == [], page.messages
        print(f"{times['elements']} triangles: opened in {opened:.1f} s, of which {times['start'] / 1000:.1f} s to start")
        print(f"a picture {times['all']:.0f} ms, rough while turning {times['coarse']:.0f} ms, "
              f"with element edges {times['edges']:.0f} ms")
        print(f"click {times['pick']:.0f} ms, other colours {times['color']:.0f} ms, filter {times['filter']:.0f} ms, "
              f"memory {times['megabytes']:.0f} MB")


main()
