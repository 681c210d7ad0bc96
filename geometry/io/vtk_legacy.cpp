// Legacy VTK, version 3.0, binary (high byte first, as that format wants).
#include <string>

#include "geometry/io/formats.h"
#include "geometry/quality.h"

namespace af2::geometry {
namespace {

constexpr std::int32_t kVtkTriangle = 5, kVtkQuad = 9;

void sectionHead(OutputFile& file, std::string_view name, std::size_t count,
                 std::string_view rest) {
  file.text(name);
  file.text(" ");
  file.number(count);
  file.text(rest);
}

void writeCells(const ModelMesh& mesh, OutputFile& file) {
  std::size_t numbers = 0;
  for (const Element& element : mesh.elements) numbers += 1 + element.vertices().size();
  sectionHead(file, "CELLS", mesh.elements.size(), " " + std::to_string(numbers) + "\n");
  for (const Element& element : mesh.elements) {
    file.bigEndian(std::int32_t{element.size()});
    for (const VertexId vertex : element.vertices()) file.bigEndian(vertex.value);
  }
  sectionHead(file, "\nCELL_TYPES", mesh.elements.size(), "\n");
  for (const Element& element : mesh.elements) {
    file.bigEndian(element.isQuad() ? kVtkQuad : kVtkTriangle);
  }
}

void writeCellData(const ModelMesh& mesh, OutputFile& file) {
  const std::size_t count = mesh.elements.size();
  sectionHead(file, "\nCELL_DATA", count, "\nFIELD FieldData 3\n");
  sectionHead(file, "face 1", count, " int\n");
  for (const std::int32_t face : mesh.face) file.bigEndian(face);
  sectionHead(file, "\nrule 1", count, " int\n");
  for (const std::uint16_t rule : mesh.rule) file.bigEndian(std::int32_t{rule});
  sectionHead(file, "\nquality 1", count, " double\n");
  for (const Element& element : mesh.elements) {
    file.bigEndian(shapeQuality(mesh.vertices, element));
  }
  file.text("\n");
}

}  // namespace

void writeVtk(const ModelMesh& mesh, OutputFile& file) {
  file.text("# vtk DataFile Version 3.0\nsurface mesh by AF2\nBINARY\nDATASET UNSTRUCTURED_GRID\n");
  sectionHead(file, "POINTS", cornerVertices(mesh).size(), " double\n");
  for (const Point3& p : cornerVertices(mesh)) {
    file.bigEndian(p.x);
    file.bigEndian(p.y);
    file.bigEndian(p.z);
  }
  file.text("\n");
  writeCells(mesh, file);
  writeCellData(mesh, file);
}

}  // namespace af2::geometry
