#!/usr/bin/python3
"""Follows every link of a site that lies in a folder: check_links.py FOLDER.

Each link to another page, picture or place of a page leads somewhere, and no page loads anything from elsewhere. Exit
code 1 if not; the broken ones are printed."""

import html.parser
import pathlib
import sys
import urllib.parse

LOADS = {("script", "src"), ("img", "src"), ("link", "href"), ("iframe", "src"), ("source", "src"), ("object", "data")}


class Page(html.parser.HTMLParser):
    """The links of a page and the places that links can lead to."""

    def __init__(self, text):
        super().__init__()
        self.links, self.places = [], {""}
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.places.update(value for name, value in attributes if name in ("id", "name") and value)
        for name in ("href", "src", "data"):
            if values.get(name) is not None and not (tag == "link" and values.get("rel") in ("canonical", "edit")):
                self.links.append((values[name], (tag, name) in LOADS))


def faults(folder):
    folder = folder.resolve()
    pages = {path: Page(path.read_text(encoding="utf-8")) for path in sorted(folder.rglob("*.html"))}
    for path, page in pages.items():
        for link, is_loaded in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme in ("http", "https") or link.startswith("//"):
                if is_loaded:
                    yield f"{path.relative_to(folder)} loads {link}"
                continue
            if parts.scheme or (path.name == "404.html" and link.startswith("/")):
                continue
            target = path.parent / urllib.parse.unquote(parts.path) if parts.path else path
            target = target / "index.html" if target.is_dir() else target
            target = target.resolve()
            if not target.exists():
                yield f"{path.relative_to(folder)} links to {link}, which is not there"
            elif target in pages and urllib.parse.unquote(parts.fragment) not in pages[target].places:
                yield f"{path.relative_to(folder)} links to {link}: that page has no such place"
    if len(pages) < 10:
        yield f"there are only {len(pages)} pages"


if __name__ == "__main__":
    found = list(faults(pathlib.Path(sys.argv[1])))
    print("\n".join(found) if found else "all links lead somewhere")
    sys.exit(1 if found else 0)
