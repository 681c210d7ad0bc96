"""Pictures that the program draws for the site: rules beside their texts, rule sets, and meshes beside their commands."""

import re
import shlex
import shutil
import subprocess
import tempfile
import pathlib

from doc_blocks import FENCE, completed
from site_pages import rule_page

TITLE = re.compile(r'^rule "([^"{}]+)"', re.M)


class Program:
    def __init__(self, af2, source):
        self.af2, self.source = af2, source

    def run(self, arguments, folder):
        return subprocess.run([self.af2, *arguments], cwd=folder, capture_output=True, text=True, check=False)


def with_rules_drawn(text, name, program, pictures):
    """Below each block that is a rule, its picture."""
    count = 0

    def drawn(match):
        nonlocal count
        titles = TITLE.findall(match.group(3)) if match.group(1) == "af2" else []
        figures = ""
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "rules.af2").write_text(completed(match.group(3)), encoding="utf-8")
            for title in titles[:2]:
                count += 1
                picture = pictures / f"{name}-{count}.svg"
                done = program.run(["draw", "rules.af2", "--rule", title, "-o", str(picture), "--size", "300"], folder)
                if done.returncode == 0 and picture.exists():
                    figures += f"\n\n<div class=\"drawn\" markdown=\"1\">\n![The rule {title}]({pictures.name}/{picture.name})\n</div>"
        return match.group(0) + figures

    return FENCE.sub(drawn, text)


def with_meshes_drawn(text, program, pictures):
    """Runs the commands of a page, and shows the pictures that they write below their blocks."""
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "examples").symlink_to(program.source / "examples")

        def drawn(match):
            figures = ""
            for command in re.findall(r"^\$ af2 (.*?)(?:  # exit code \d)?$", match.group(3), re.M):
                words = shlex.split(command)
                done = program.run(words, folder)
                for word in words:
                    if re.fullmatch(r"[\w-]+\.(png|svg)", word):
                        if not (pathlib.Path(folder) / word).exists():
                            raise SystemExit(f"af2 {command} wrote no {word}:\n{done.stderr}")
                        shutil.copy(pathlib.Path(folder) / word, pictures / word)
                        figures += f"\n\n![{word}]({pictures.name}/{word})"
            return match.group(0) + figures

        return FENCE.sub(drawn, text)


def comment_on_top(text):
    """The first comment of a rule file, as a paragraph."""
    lines = []
    for line in text.splitlines():
        if line.startswith("# "):
            lines.append(line[2:])
        elif lines:
            break
    return " ".join(lines)


def rule_set_page(path, program, pages):
    """The page of a rule set, with all its rules; what `af2 doc` writes lies beside it."""
    name, text = rule_page(path), (program.source / path).read_text(encoding="utf-8")
    folder = pages / "rules" / name
    done = program.run(["doc", str(program.source / path), "-o", str(folder)], program.source)
    if done.returncode != 0:
        raise SystemExit(f"af2 doc {path}:\n{done.stderr}")
    titles = re.findall(r'<article id="rule-(\d+)">.*?<h2>(.*?)</h2>', (folder / "index.html").read_text(encoding="utf-8"), re.S)
    figures = "\n".join(
        f'<figure><a href="{name}/index.html#rule-{i}"><img loading="lazy" src="{name}/pictures/rule-{i}-all.svg" alt="{title}"></a>'
        f"<figcaption>{title}</figcaption></figure>"
        for i, title in titles if (folder / "pictures" / f"rule-{i}-all.svg").exists())
    return (f"# {'/'.join(path.with_suffix('').parts[1:])}\n\n{comment_on_top(text)}\n\n"
            f'<p><a href="{name}/index.html">All rules with their texts, tests and free zones</a></p>\n\n'
            f'<div class="gallery">\n{figures}\n</div>\n\n## The file\n\n~~~~~af2\n{text.rstrip()}\n~~~~~\n')
