"""include_directions.py SOURCE: the folders are those of docs/architecture.md, and include only what it lets them.

The tables of that page have the columns folder, purpose and "may use". A folder may also use itself. A name
in "may use" is a folder of the same component, or a component of which every folder may be used."""

import collections
import pathlib
import re
import sys

SOURCE = pathlib.Path(sys.argv[1])
COMPONENTS = ("engine", "dsl", "geometry", "cli", "python")
MOST_UNITS = 30  # a header with its source is one
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.M)

CAD_HEADER = re.compile(
    r"(BRep|TopoDS|TopExp|TopAbs|TopLoc|TopTools|Geom|GProp|gp_|gp\.|STEP|IGES|XCAF|XSControl|TDoc|TDF|TCol|Standard|Shape"
    r"|Bnd|Precision|ElSLib|ElCLib|Poly_|Message|Interface|Quantity|NCollection|Adaptor|Extrema|CPnts|GC|OSD|TColStd"
    r"|BinTools)[A-Za-z0-9_]*\.hxx")
# Which files alone may include the headers of a library.
LIBRARIES = [
    (re.compile(r"boost/spirit"), re.compile(r"dsl/syntax/(grammar\.cpp|token_parsers\.h)"), "Boost.Spirit"),
    (re.compile(r"CGAL/"), re.compile(r"engine/base/predicates\.cpp|dsl/shapes/exact\.(h|cpp)"), "CGAL"),
    (re.compile(r"cairo"), re.compile(r"dsl/picture/canvas\.cpp|geometry/picture/png_file\.cpp"), "Cairo"),
    (re.compile(r"Eigen/"), re.compile(r"geometry/faceted/sparse_system\.cpp"), "Eigen"),
    (re.compile(r"httplib"), re.compile(r"cli/playground/http/http_module\.cpp"), "cpp-httplib"),
    (CAD_HEADER, re.compile(r"geometry/occ/.*"), "OpenCASCADE"),
    (re.compile(r"(tbb|oneapi)/"), re.compile(r".*\.cpp"), "a TBB type in a header"),
    # read_model.cpp keeps OpenCASCADE from talking, and must name the streams for that.
    (re.compile(r"mpi\.h$"), re.compile(r"(geometry|cli)/mpi/.*"), "MPI"),
    (re.compile(r"metis\.h$"), re.compile(r"geometry/mpi/partition/divide_mesh\.cpp"), "METIS"),
    (re.compile(r"iostream$|CLI/"), re.compile(r"cli/.*|geometry/occ/read/read_model\.cpp"), "the terminal"),
]

failures = []


def rows():
    """The rows of the tables of folders: folder, purpose, names that it may use."""
    page = (SOURCE / "docs/architecture.md").read_text(encoding="utf-8")
    for line in page.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        match = re.fullmatch(r"`([a-z_/]+)/`", cells[0])
        if match and len(cells) == 3:
            yield match.group(1), cells[1], re.findall(r"`([a-z_/]+)`", cells[2])


def component_of(folder):
    return folder.split("/")[0]


allowed, purposes = {}, {}
for folder, purpose, uses in rows():
    allowed[folder] = {use if use in COMPONENTS else f"{component_of(folder)}/{use}" for use in uses}
    purposes[folder] = purpose
    if not purpose:
        failures.append(f"docs/architecture.md: {folder}/ has no purpose")
for folder, uses in allowed.items():
    for use in uses:
        if use not in allowed and use not in COMPONENTS:
            failures.append(f"docs/architecture.md: {folder}/ may use {use}/, which is no folder")

files = [
    path.relative_to(SOURCE)
    for component in COMPONENTS
    for path in sorted((SOURCE / component).rglob("*"))
    if path.suffix in (".h", ".cpp")
]
units = collections.defaultdict(set)
for file in files:
    units[str(file.parent)].add(file.stem)
for folder, names in units.items():
    if folder not in allowed:
        failures.append(f"docs/architecture.md does not list {folder}/")
    if len(names) > MOST_UNITS:
        failures.append(f"{folder}/ has {len(names)} units; more than {MOST_UNITS} are hard to survey")
for folder in allowed:
    if folder not in units:
        failures.append(f"docs/architecture.md lists {folder}/, which has no sources")

used = collections.defaultdict(dict)  # by folder and folder that it uses: where
for file in files:
    folder = str(file.parent)
    for kind, name in INCLUDE.findall((SOURCE / file).read_text(encoding="utf-8")):
        for library, home, title in LIBRARIES:
            if library.match(name) and not home.fullmatch(str(file)):
                failures.append(f"{file} includes <{name}>: {title} is not for this file")
        if kind == "<" or name.endswith(".inc"):  # the build makes these
            continue
        target = str(pathlib.PurePosixPath(name).parent)
        if component_of(target) not in COMPONENTS or not (SOURCE / name).is_file():
            failures.append(f"{file} includes \"{name}\", which is no header of AF2")
        elif target != folder:
            used[folder].setdefault(target, f"{file} includes {name}")
            permitted = allowed.get(folder, set())
            if target not in permitted and (component_of(target) == component_of(folder) or component_of(target) not in permitted):
                failures.append(f"{file} includes {name}: {folder}/ may not use {target}/ (docs/architecture.md)")
for folder, uses in allowed.items():
    for use in sorted(uses):
        if use not in used[folder] and not any(component_of(target) == use for target in used[folder]):
            failures.append(f"docs/architecture.md: {folder}/ may use {use}/ and does not")


def find_cycle(graph):
    """The folders of a cycle in order, or none."""
    state, path = {}, []

    def visit(node):
        state[node] = "open"
        path.append(node)
        for target in sorted(graph.get(node, ())):
            if state.get(target) == "open":
                return path[path.index(target):] + [target]
            if target not in state and (cycle := visit(target)):
                return cycle
        state[node] = "done"
        path.pop()
        return None

    for node in sorted(graph):
        if node not in state and (cycle := visit(node)):
            return cycle
    return None


if cycle := find_cycle(used):
    failures.append("folders use each other in a circle: " + " -> ".join(cycle))
    failures += [f"  {used[a][b]}" for a, b in zip(cycle, cycle[1:])]

print("\n".join(failures) if failures else f"{len(units)} folders, {len(files)} files")
sys.exit(1 if failures else 0)
