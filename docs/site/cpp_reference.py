"""The reference of the C++ library, made by Doxygen from the public headers, as pages of the site."""

import collections
import html
import pathlib
import re
import subprocess
import xml.etree.ElementTree as ElementTree

COMPONENTS = {
    "engine": "The engine: fronts, rules as objects, charts, sizes, meshes",
    "dsl": "The rule language: loading, tests, evaluation, checks, pictures",
    "geometry": "Planar domains, surfaces of triangles, meshes and their files",
    "occ": "CAD models (component `occ`)",
}
SETTINGS = """
GENERATE_HTML = NO
GENERATE_LATEX = NO
GENERATE_XML = YES
XML_PROGRAMLISTING = NO
QUIET = YES
HAVE_DOT = NO
WARNINGS = NO
EXTRACT_ALL = YES
JAVADOC_AUTOBRIEF = YES
ENABLE_PREPROCESSING = YES
MACRO_EXPANSION = YES
PREDEFINED = AF2_EXPORT=
FULL_PATH_NAMES = YES
"""


def component_of(inside, installed):
    return "occ" if "/occ/" in inside else installed.split("/")[1]


def text_of(element):
    """A description as HTML, without paragraphs."""
    if element is None:
        return ""
    inner = html.escape(element.text or "")
    for child in element:
        text = text_of(child)
        if child.tag == "computeroutput":
            text = f"<code>{text}</code>"
        elif child.tag in ("listitem", "parametername"):
            text = f" {text};" if child.tag == "listitem" else f" <code>{text}</code>: "
        elif child.tag in ("para", "simplesect", "parameteritem"):
            text += " "
        inner += text + html.escape(child.tail or "")
    return re.sub(r"\s+", " ", inner) if element.tag.endswith("description") else inner


def described(element):
    return " ".join(text for text in (text_of(element.find("briefdescription")).strip(),
                                      text_of(element.find("detaileddescription")).strip()) if text)


def plain(element):
    return "".join(element.itertext()) if element is not None else ""


def tidy(code):
    return re.sub(r"\s+", " ", code).replace(" &", "&").replace(" *", "*").replace("< ", "<").replace(" >", ">").strip()


def signature(member):
    kind, name = member.get("kind"), plain(member.find("name"))
    if kind == "enum":
        values = ", ".join(plain(value.find("name")) for value in member.findall("enumvalue"))
        return f"enum {'class ' if member.get('strong') == 'yes' else ''}{name} {{ {values} }}"
    if kind == "typedef":
        return tidy(plain(member.find("definition")))
    code = f"{plain(member.find('type'))} {name}"
    if kind == "function":
        parameters = [tidy(f"{plain(p.find('type'))} {plain(p.find('declname'))}"
                           + (f" = {plain(p.find('defval'))}" if p.find("defval") is not None else ""))
                      for p in member.findall("param")]
        code += f"({', '.join(parameters)})" + (" const" if member.get("const") == "yes" else "")
    else:
        code += plain(member.find("argsstring"))  # of pointers to functions
        code += plain(member.find("initializer")).replace("=", " = ", 1) if member.find("initializer") is not None else ""
    return tidy(code)


def rows(members):
    """A table of members; one without a description stands with what is above it."""
    lines = []
    for member in members:
        text = described(member)
        for value in member.findall("enumvalue"):
            if described(value):
                text += f"<br><code>{plain(value.find('name'))}</code>: {described(value)}"
        lines.append(f"<tr><td><code>{html.escape(signature(member))}</code></td><td>{text}</td></tr>")
    return "\n<div class=\"members\"><table>\n" + "\n".join(lines) + "\n</table></div>\n" if lines else ""


def public_members(compound):
    return [member for section in compound.findall("sectiondef") for member in section.findall("memberdef")
            if member.get("prot") == "public" and not plain(member.find("name")).startswith("operator")]


class Header:
    def __init__(self):
        self.classes, self.members = [], []


def read(folder):
    """What Doxygen found, by the path of the header."""
    headers = collections.defaultdict(Header)
    for path in sorted(folder.glob("*.xml")):
        for compound in ElementTree.parse(path).getroot().findall("compounddef"):
            if compound.get("kind") in ("class", "struct") and compound.get("prot", "public") == "public":
                headers[compound.find("location").get("file")].classes.append(compound)
            if compound.get("kind") == "namespace":
                for member in public_members(compound):
                    headers[member.find("location").get("file")].members.append(member)
    return headers


def purpose(path):
    """The line on top of a header that says what it is for."""
    lines = []
    for line in path.read_text(encoding="utf-8").splitlines():
        if not line.startswith("//"):
            break
        lines.append(line[2:].strip())
    return " ".join(lines)


def header_text(source, inside, installed, header):
    text = f"\n## `<{installed}>`\n\n{purpose(source / inside)}\n"
    for compound in sorted(header.classes, key=lambda c: int(c.find("location").get("line"))):
        name = plain(compound.find("compoundname")).removeprefix("af2::")
        bases = ", ".join(plain(base) for base in compound.findall("basecompoundref"))
        text += f"\n### {compound.get('kind')} `{name}`\n\n{described(compound)}"
        text += f" Derived from <code>{html.escape(bases)}</code>.\n" if bases else "\n"
        text += rows(public_members(compound))
    if header.members:
        text += ("\n### Functions and others\n" if header.classes else "") + rows(header.members)
    return text


def pages(source, public_headers, work):
    """Pairs of the name of a page and its text."""
    listed = [line.split("=") for line in public_headers.read_text().split() if line.split("=")[0].endswith(".h")]
    config = work / "Doxyfile"
    inputs = " \\\n".join(f'"{source / inside}"' for inside, _ in listed)
    config.write_text(f"{SETTINGS}OUTPUT_DIRECTORY = \"{work}\"\nSTRIP_FROM_PATH = \"{source}\"\nINPUT = {inputs}\n")
    subprocess.run(["doxygen", config], check=True, stdout=subprocess.DEVNULL)
    found = read(work / "xml")
    for component, title in COMPONENTS.items():
        text = f"# {title}\n\n[AF2 in your own program](../embedding.md) shows how these are used.\n"
        for inside, installed in sorted(listed, key=lambda pair: pair[1]):
            if component_of(inside, installed) == component:
                text += header_text(source, inside, installed, found.get(inside, found.get(str(source / inside), Header())))
        yield component, text
