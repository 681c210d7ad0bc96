"""Compiles the C++ of the documentation: doc_code.py COMPILER SOURCE BUILD OPENCASCADE_HEADERS MPI_HEADERS.

Each block fenced as ```cpp is the body of a function, in which `options` are those of a mesh; a block that begins
with #include is a part of a file. Without MPI, blocks that need it are left out. Blocks that derive from a class of AF2 would need more; there are none."""

import pathlib
import re
import subprocess
import sys
import tempfile

COMPILER, SOURCE, BUILD = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
OPENCASCADE, MPI = sys.argv[4], [folder for folder in sys.argv[5].split(":") if folder]
FENCE = re.compile(r"^```cpp\n(.*?)^```$", re.M | re.S)
BEFORE = """
#include <cmath>
#include <memory>
#include <optional>
#include <span>

#include <af2/dsl/registry.h>
#include <af2/dsl/rule_file.h>
#include <af2/engine/algorithm.h>
#include <af2/engine/element_metric.h>
#include <af2/geometry/mesh_faceted.h>
#include <af2/geometry/mesh_files.h>
#include <af2/geometry/mesh_model.h>

struct MyMetric final : af2::AF2ElementMetric {
  std::optional<double> badness(std::span<const af2::Point2>) const override { return 0; }
};
"""

code, count = BEFORE, 0
for page in [SOURCE / "README.md", *sorted((SOURCE / "docs").glob("*.md"))]:
    text = page.read_text(encoding="utf-8")
    for block in FENCE.finditer(text):
        count += 1
        line = text.count("\n", 0, block.start()) + 2
        if "<af2/mpi/" in block.group(1) and not MPI:
            continue
        if block.group(1).startswith("#include"):
            code += f'#line {line} "{page.relative_to(SOURCE)}"\n{block.group(1)}'
            continue
        code += f"void block{count}() {{\n[[maybe_unused]] af2::geometry::MeshingOptions options;\n{{\n"
        code += f'#line {line} "{page.relative_to(SOURCE)}"\n{block.group(1)}}}\n}}\n'

with tempfile.TemporaryDirectory() as folder:
    source = pathlib.Path(folder) / "blocks.cpp"
    source.write_text(code, encoding="utf-8")
    compiled = subprocess.run([COMPILER, "-std=c++20", "-fsyntax-only", f"-I{BUILD}/include", f"-I{SOURCE}",
                               "-isystem", OPENCASCADE, *(f"-isystem{folder}" for folder in MPI), source])
print(f"{count} blocks of C++ compile" if compiled.returncode == 0 else "the C++ of the documentation does not compile")
sys.exit(1 if compiled.returncode != 0 or count < 3 else 0)
