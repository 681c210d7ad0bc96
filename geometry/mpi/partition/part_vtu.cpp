// Parts of meshes in VTK's XML format. Ghosts are marked as VTK marks them, so that filters and
// views leave them out.
#include <array>
#include <string>
#include <string_view>

#include "geometry/formats/vtk_cells.h"
#include "geometry/io/base64.h"
#include "geometry/mpi/partition/part_files.h"

namespace af2::mpi {

namespace {

using namespace geometry;

struct Column {
  std::string_view type, name;
};

// Their names are those that ParaView looks for.
constexpr std::array kOfVertices{Column{"Int64", "GlobalNodeIds"}, Column{"Int64", "number"},
                                 Column{"Int32", "owner"}, Column{"UInt8", "vtkGhostType"}};
constexpr std::array kOfElements{Column{"Int64", "GlobalElementIds"}, Column{"Int64", "number"},
                                 Column{"Int32", "owner"}, Column{"UInt8", "vtkGhostType"},
                                 Column{"Int32", "face"}};
constexpr std::uint8_t kGhost = 1;

template <class Value, class At>
void writeArray(const Column& column, std::size_t count, int components, OutputFile& file, At at) {
  file.text("<DataArray type=\"" + std::string(column.type) + "\" Name=\"" +
            std::string(column.name) + "\"");
  if (components > 1) file.text(" NumberOfComponents=\"" + std::to_string(components) + "\"");
  file.text(" format=\"binary\">\n");
  Base64Stream stream(file);
  stream.put(std::uint64_t{count * static_cast<std::size_t>(components) * sizeof(Value)});
  for (std::size_t i = 0; i < count; ++i) at(i, [&](Value value) { stream.put(value); });
  stream.finish();
  file.text("\n</DataArray>\n");
}

template <class Value, class At>
void writeValues(const Column& column, std::size_t count, OutputFile& file, At at) {
  writeArray<Value>(column, count, 1, file,
                    [&](std::size_t i, const auto& put) { put(static_cast<Value>(at(i))); });
}

void writeVertices(const OwnedPart& part, OutputFile& file) {
  const std::size_t count = part.vertices.size();
  const auto& [ids, numbers, owners, ghosts] = kOfVertices;
  file.text("<PointData GlobalIds=\"GlobalNodeIds\">\n");
  writeValues<std::int64_t>(ids, count, file, [&](auto v) { return part.vertexIds[v]; });
  writeValues<std::int64_t>(numbers, count, file, [&](auto v) { return part.vertexNumbers[v]; });
  writeValues<std::int32_t>(owners, count, file, [&](auto v) { return part.vertexOwners[v]; });
  writeValues<std::uint8_t>(ghosts, count, file,
                            [&](auto v) { return v < part.ownedVertices ? 0 : kGhost; });
  file.text("</PointData>\n");
}

void writeElements(const OwnedPart& part, OutputFile& file) {
  const std::size_t count = part.elements.size();
  const auto& [ids, numbers, owners, ghosts, face] = kOfElements;
  file.text("<CellData GlobalIds=\"GlobalElementIds\">\n");
  writeValues<std::int64_t>(ids, count, file, [&](auto e) { return part.elementIds[e]; });
  writeValues<std::int64_t>(numbers, count, file, [&](auto e) { return part.elementNumbers[e]; });
  writeValues<std::int32_t>(owners, count, file, [&](auto e) { return part.elementOwners[e]; });
  writeValues<std::uint8_t>(ghosts, count, file,
                            [&](auto e) { return e < part.ownedElements ? 0 : kGhost; });
  writeValues<std::int32_t>(face, count, file, [&](auto e) { return part.face[e]; });
  file.text("</CellData>\n");
}

void writePoints(const OwnedPart& part, OutputFile& file) {
  file.text("<Points>\n");
  writeArray<double>({"Float64", "Points"}, part.vertices.size(), 3, file,
                     [&](std::size_t v, const auto& put) {
                       const Point3& p = part.vertices[v];
                       for (const double x : {p.x, p.y, p.z}) put(x);
                     });
  file.text("</Points>\n");
}

std::uint8_t typeOf(const OwnedPart& part, const Element& element) {
  if (part.midsides.empty()) return element.isQuad() ? kVtkQuad : kVtkTriangle;
  return element.isQuad() ? kVtkQuad2 : kVtkTriangle2;
}

void writeCells(const OwnedPart& part, OutputFile& file) {
  std::vector<std::int64_t> vertices, ends;
  for (std::size_t e = 0; e < part.elements.size(); ++e) {
    const auto corners = part.elements[e].vertices();
    for (const VertexId v : corners) vertices.push_back(v.value);
    for (std::size_t i = 0; !part.midsides.empty() && i < corners.size(); ++i)
      vertices.push_back(part.midsides[e][i].value);
    ends.push_back(static_cast<std::int64_t>(vertices.size()));
  }
  file.text("<Cells>\n");
  writeValues<std::int64_t>({"Int64", "connectivity"}, vertices.size(), file,
                            [&](auto i) { return vertices[i]; });
  writeValues<std::int64_t>({"Int64", "offsets"}, ends.size(), file,
                            [&](auto i) { return ends[i]; });
  writeValues<std::uint8_t>({"UInt8", "types"}, part.elements.size(), file,
                            [&](auto e) { return typeOf(part, part.elements[e]); });
  file.text("</Cells>\n");
}

constexpr std::string_view kAttributes =
    "version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n";

template <class Columns>
void nameColumns(const Columns& columns, OutputFile& file) {
  for (const Column& column : columns)
    file.text("<PDataArray type=\"" + std::string(column.type) + "\" Name=\"" +
              std::string(column.name) + "\"/>\n");
}

}  // namespace

void writePartVtu(const OwnedPart& part, OutputFile& file) {
  file.text("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" ");
  file.text(kAttributes);
  file.text("<UnstructuredGrid>\n<Piece NumberOfPoints=\"");
  file.number(part.vertices.size());
  file.text("\" NumberOfCells=\"");
  file.number(part.elements.size());
  file.text("\">\n");
  writeVertices(part, file);
  writeElements(part, file);
  writePoints(part, file);
  writeCells(part, file);
  file.text("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
}

void writePvtu(const OwnedPart& part, const std::filesystem::path& all, OutputFile& file) {
  file.text("<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" ");
  file.text(kAttributes);
  file.text("<PUnstructuredGrid GhostLevel=\"1\">\n<PPointData GlobalIds=\"GlobalNodeIds\">\n");
  nameColumns(kOfVertices, file);
  file.text("</PPointData>\n<PCellData GlobalIds=\"GlobalElementIds\">\n");
  nameColumns(kOfElements, file);
  file.text(
      "</PCellData>\n<PPoints>\n<PDataArray type=\"Float64\" Name=\"Points\" "
      "NumberOfComponents=\"3\"/>\n</PPoints>\n");
  for (int process = 0; process < part.processes; ++process)
    file.text("<Piece Source=\"" + partFileOf(all, process).filename().string() + "\"/>\n");
  file.text("</PUnstructuredGrid>\n</VTKFile>\n");
}

}  // namespace af2::mpi
