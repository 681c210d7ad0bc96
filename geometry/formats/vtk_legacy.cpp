// Legacy VTK, version 3.0, binary (high byte first, as that format wants).
#include <string>

#include "geometry/formats/vtk_cells.h"
#include "geometry/io/formats.h"
#include "geometry/mesh/quality.h"

namespace af2::geometry {
namespace {

void sectionHead(OutputFile& file, std::string_view name, std::size_t count,
                 std::string_view rest) {
  file.text(name);
  file.text(" ");
  file.number(count);
  file.text(rest);
}

void writeCells(const ModelMesh& mesh, Lines lines, OutputFile& file) {
  const std::size_t cells = elementCount(mesh) + lines.size();
  const std::size_t numbers = 3 * lines.size() + 4 * elementCount(mesh) + quadCount(mesh);
  sectionHead(file, "CELLS", cells, " " + std::to_string(numbers) + "\n");
  forEachElement(mesh, [&](const MeshSlice& slice, std::size_t i) {
    const Element& element = slice.elements[i];
    file.bigEndian(std::int32_t{element.size()});
    for (const VertexId vertex : element.vertices()) file.bigEndian(vertex.value);
  });
  for (const LineElement& line : lines) {
    file.bigEndian(std::int32_t{2});
    for (const VertexId vertex : {line.from, line.to}) file.bigEndian(vertex.value);
  }
  sectionHead(file, "\nCELL_TYPES", cells, "\n");
  forEachRun(mesh, [&](const ElementRun& run) {
    for (std::size_t i = 0; i < run.count; ++i)
      file.bigEndian(std::int32_t{run.areQuads ? kVtkQuad : kVtkTriangle});
  });
  for (std::size_t i = 0; i < lines.size(); ++i) file.bigEndian(std::int32_t{kVtkLine});
}

void writeCellData(const ModelMesh& mesh, Lines lines, OutputFile& file) {
  const std::size_t count = elementCount(mesh) + lines.size();
  const int arrays = 4 + (hasScores(mesh) ? 1 : 0) + (lines.empty() ? 0 : 2);
  sectionHead(file, "\nCELL_DATA", count, "\nFIELD FieldData " + std::to_string(arrays) + "\n");
  const auto repeat = [&](std::size_t times, auto value) {
    for (std::size_t i = 0; i < times; ++i) file.bigEndian(value);
  };
  sectionHead(file, "face 1", count, " int\n");
  forEachRun(mesh, [&](const ElementRun& run) { repeat(run.count, run.face); });
  repeat(lines.size(), kFaceOfLine);
  sectionHead(file, "\nrule 1", count, " int\n");
  forEachElement(mesh, [&](const MeshSlice& slice, std::size_t i) {
    file.bigEndian(ruleNumber(slice.origins[i]));
  });
  repeat(lines.size(), kNoRule);
  sectionHead(file, "\nlevel 1", count, " int\n");
  forEachElement(mesh, [&](const MeshSlice& slice, std::size_t i) {
    file.bigEndian(std::int32_t{levelNumber(slice.origins[i])});
  });
  repeat(lines.size(), std::int32_t{kNoLevel});
  if (hasScores(mesh)) {
    sectionHead(file, "\nscore 1", count, " float\n");
    forEachElement(mesh,
                   [&](const MeshSlice& slice, std::size_t i) { file.bigEndian(slice.scores[i]); });
    repeat(lines.size(), kScoreOfLine);
  }
  sectionHead(file, "\nquality 1", count, " double\n");
  forEachElement(mesh, [&](const MeshSlice& slice, std::size_t i) {
    file.bigEndian(shapeQuality(slice, slice.elements[i]));
  });
  repeat(lines.size(), kQualityOfLine);
  file.text("\n");
  if (lines.empty()) return;
  sectionHead(file, "edge 1", count, " int\n");
  repeat(elementCount(mesh), kOnNoEdge);
  for (const LineElement& line : lines) file.bigEndian(std::int32_t{line.edge});
  sectionHead(file, "\nboundary 1", count, " int\n");
  repeat(elementCount(mesh), kOnNoEdge);
  for (const LineElement& line : lines) file.bigEndian(std::int32_t{line.boundary});
  file.text("\n");
}

}  // namespace

void writeVtk(const ModelMesh& mesh, const Extras& extras, OutputFile& file) {
  const Lines lines = extras.lines;
  file.text("# vtk DataFile Version 3.0\nsurface mesh by AF2\nBINARY\nDATASET UNSTRUCTURED_GRID\n");
  sectionHead(file, "POINTS", cornerCount(mesh), " double\n");
  forEachCorner(mesh, [&](const Point3& p) {
    file.bigEndian(p.x);
    file.bigEndian(p.y);
    file.bigEndian(p.z);
  });
  file.text("\n");
  writeCells(mesh, lines, file);
  writeCellData(mesh, lines, file);
}

}  // namespace af2::geometry
