"""Turns pages of docs/, which read well in a repository, into those that MkDocs takes."""

import os
import pathlib
import re

from doc_blocks import FENCE

LINK_OR_CODE = re.compile(r"`[^`]*`|(?<=\]\()([^)#\s:]+)(?=[)#])")


class Links:
    """Where links to files of the repository lead on the site. `sources` collects files and folders that need a page."""

    def __init__(self, source):
        self.source, self.sources = source, set()

    def target(self, link, page):
        """`page` is the path of the page in the repository."""
        path = pathlib.Path(os.path.normpath(page.parent / link))
        if path.parent == pathlib.Path("docs/drawn"):  # pictures that are made for the site
            return link
        if not (self.source / path).exists():
            raise SystemExit(f"{page}: there is no {path}")
        if path.parts[0] == "docs":
            return str(pathlib.Path(*path.parts[1:]))
        if path == pathlib.Path("README.md"):
            return "index.md"
        if path.suffix == ".af2" and path.parts[0] == "rules":
            return f"rules/{rule_page(path)}.md"
        self.sources.add(path)
        return f"sources/{source_page(path)}.md"


def rule_page(path):
    """"tri-even" of rules/tri/even.af2."""
    return "-".join(path.with_suffix("").parts[1:])


def source_page(path):
    return "-".join(path.parts).replace(".", "-")


def block(match):
    """Headers of blocks as the site's highlighter wants them."""
    language, info, body = match.group(1), match.group(2).strip(), match.group(3)
    name, _, finding = info.partition("finds ")
    title = name.strip() + (f" (af2 check finds {finding})" if finding else "")
    head = f'{{.{language} title="{title.strip()}"}}' if title.strip() else language
    return f"```{head}\n{body}```"


def outside_blocks(text, change):
    parts, end = [], 0
    for match in FENCE.finditer(text):
        parts += [change(text[end:match.start()]), match.group(0)]
        end = match.end()
    return "".join(parts + [change(text[end:])])


def title_of(path):
    """The first heading of a page."""
    return next(line[2:] for line in path.read_text(encoding="utf-8").splitlines() if line.startswith("# "))


def prepared(text, page, links):
    """The text of a page of the repository as a page of the site."""
    def titled(match):
        path = links.source / "docs" / match.group(1)
        return f"[{title_of(path)}](" if path.exists() else match.group(0)

    def change(part):
        part = re.sub(r"\[(?:docs/)?([\w-]+\.md)\]\(", titled, part)  # files have names, pages have titles
        part = LINK_OR_CODE.sub(lambda m: links.target(m.group(1), page) if m.group(1) else m.group(0), part)
        # A bar within code in a table needs no backslash here.
        part = "\n".join(re.sub(r"`[^`]*`", lambda m: m.group(0).replace("\\|", "|"), line) if line.startswith("|") else line
                         for line in part.split("\n"))
        # A list needs an empty line before it.
        return re.sub(r"(?m)^(?![*\-|#]|\d+\. | )(\S.*)\n(?=(\* |1\. ))", r"\1\n\n", part)

    return FENCE.sub(block, outside_blocks(text, change))


def file_page(path, source):
    """A page that shows a file of the repository, or those of a folder."""
    place = source / path
    files = [place] if place.is_file() else sorted(p for p in place.rglob("*") if p.is_file() and p.stat().st_size < 40_000)
    text = f"# {path}\n"
    languages = {".cpp": "cpp", ".h": "cpp", ".py": "python", ".json": "json", ".txt": "cmake", ".af2": "af2", ".js": "js"}
    for file in files:
        try:
            content = file.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue
        name = file.relative_to(place).as_posix() if place.is_dir() else path.name
        if content and "node_modules" not in name:
            text += f"\n## {name}\n\n~~~~~{languages.get(file.suffix, '')}\n{content.rstrip()}\n~~~~~\n"
    return text
