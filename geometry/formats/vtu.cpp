// VTK's XML format. All arrays are inline base64, without compression unless it is asked for: read
// by everything that reads VTU, and the same bytes for the same mesh.
#include <array>
#include <concepts>
#include <cstdlib>
#include <map>
#include <string>

#include "geometry/formats/compressed_array.h"
#include "geometry/formats/vtk_cells.h"
#include "geometry/io/base64.h"
#include "geometry/io/formats.h"
#include "geometry/mesh/quality.h"

namespace af2::geometry {
namespace {

/// The file, and how it holds arrays.
struct XmlOutput {
  OutputFile& file;
  bool isCompressed = false;

  void text(std::string_view bytes) { file.text(bytes); }
  void number(std::integral auto value) { file.number(value); }
};

struct ArrayHead {
  std::string_view type, name;
  int components = 1;
};

std::string xmlEscaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else if (static_cast<unsigned char>(c) < ' ')
      result += ' ';
    else
      result += c;
  }
  return result;
}

/// One data array; `fill` puts exactly `bytes` bytes into the stream.
template <class Fill>
void dataArray(XmlOutput& file, const ArrayHead& head, std::uint64_t bytes, Fill fill) {
  file.text("<DataArray type=\"");
  file.text(head.type);
  file.text("\" Name=\"");
  file.text(xmlEscaped(head.name));
  if (head.components > 1) {
    file.text("\" NumberOfComponents=\"");
    file.number(head.components);
  }
  file.text("\" format=\"binary\">\n");
  if (file.isCompressed) {
    CompressedArray array(file.file);
    fill(array);
    array.finish();
  } else {
    Base64Stream stream(file.file);
    stream.put(bytes);
    fill(stream);
    stream.finish();
  }
  file.text("\n</DataArray>\n");
}

void writeField(const std::string& name, const std::vector<int>& values, XmlOutput& file) {
  file.text("<DataArray type=\"Int32\" Name=\"");
  file.text(xmlEscaped(name));
  file.text("\" NumberOfTuples=\"");
  file.number(values.size());
  file.text("\" format=\"ascii\">");
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0) file.text(" ");
    file.number(values[i]);
  }
  file.text("</DataArray>\n");
}

/// In the order of the names.
std::map<std::string, std::vector<int>> facesByName(const ModelMesh& mesh) {
  std::map<std::string, std::vector<int>> faces;
  for (const FaceReport& face : mesh.faces)
    if (!face.name.empty()) faces[face.name].push_back(face.id);
  return faces;
}

/// Readers of VTU do not agree on arrays of text. So each rule becomes a number named after it:
/// a field "rule: NAME" that holds the id; and each group a field that holds the ids of its faces,
/// or of its edges.
void writeNames(const ModelMesh& mesh, XmlOutput& file) {
  file.text("<FieldData>\n");
  for (std::size_t rule = 0; rule < mesh.ruleNames.size(); ++rule)
    writeField("rule: " + mesh.ruleNames[rule], {static_cast<int>(rule)}, file);
  for (const auto& [name, faces] : facesByName(mesh)) writeField("face: " + name, faces, file);
  for (const FaceGroup& group : mesh.groups)
    writeField(std::string(toString(group.kind)) + ": " + group.name, group.faces, file);
  for (const EdgeGroup& boundary : mesh.boundaries)
    writeField("boundary: " + shownName(boundary), boundary.edges, file);
  file.text("</FieldData>\n");
}

void writePoints(const ModelMesh& mesh, XmlOutput& file) {
  file.text("<Points>\n");
  dataArray(file, {"Float64", "Points", 3}, vertexCount(mesh) * 3 * sizeof(double), [&](auto& out) {
    forEachSlice(mesh, [&](const MeshSlice& slice) {
      for (const Point3& p : slice.vertices) {
        out.put(p.x);
        out.put(p.y);
        out.put(p.z);
      }
    });
  });
  file.text("</Points>\n");
}

void writeXmlCells(const ModelMesh& mesh, Lines lines, XmlOutput& file) {
  const std::size_t cells = elementCount(mesh) + lines.size();
  const bool isSecondOrder = !mesh.midsides.empty();
  const int perCorner = isSecondOrder ? 2 : 1, perLine = isSecondOrder ? 3 : 2;
  const std::uint64_t vertices =
      static_cast<std::uint64_t>(perLine) * lines.size() +
      static_cast<std::uint64_t>(perCorner) * (3 * elementCount(mesh) + quadCount(mesh));
  file.text("<Cells>\n");
  dataArray(file, {"Int32", "connectivity"}, vertices * 4, [&](auto& out) {
    forEachElement(mesh, [&](const MeshSlice& slice, std::size_t e) {
      const auto corners = slice.elements[e].vertices();
      for (const VertexId vertex : corners) out.put(vertex.value);
      for (std::size_t i = 0; isSecondOrder && i < corners.size(); ++i)
        out.put(mesh.midsides[slice.firstElement + e][i].value);
    });
    for (const LineElement& line : lines) {
      for (const VertexId end : {line.from, line.to}) out.put(end.value);
      if (isSecondOrder) out.put(line.middle.value);
    }
  });
  dataArray(file, {"Int64", "offsets"}, cells * 8, [&](auto& out) {
    std::int64_t end = 0;
    forEachRun(mesh, [&](const ElementRun& run) {
      const int corners = run.areQuads ? 4 : 3;
      for (std::size_t i = 0; i < run.count; ++i) out.put(end += perCorner * corners);
    });
    for (std::size_t i = 0; i < lines.size(); ++i) out.put(end += perLine);
  });
  dataArray(file, {"UInt8", "types"}, cells, [&](auto& out) {
    forEachRun(mesh, [&](const ElementRun& run) {
      const auto type = isSecondOrder ? (run.areQuads ? kVtkQuad2 : kVtkTriangle2)
                                      : (run.areQuads ? kVtkQuad : kVtkTriangle);
      for (std::size_t i = 0; i < run.count; ++i) out.put(type);
    });
    for (std::size_t i = 0; i < lines.size(); ++i) out.put(isSecondOrder ? kVtkLine2 : kVtkLine);
  });
  file.text("</Cells>\n");
}

void writePointData(const ModelMesh& mesh, XmlOutput& file) {
  if (mesh.wantedSizes.empty()) return;
  file.text("<PointData>\n");
  dataArray(file, {"Float64", "wanted_size"}, vertexCount(mesh) * 8, [&](auto& out) {
    forEachSlice(mesh, [&](const MeshSlice& slice) {
      for (const double size : slice.wantedSizes) out.put(size);
    });
  });
  file.text("</PointData>\n");
}

/// By face: the index of its first group of a kind, counted from 1 within the kind; 0: none.
std::map<std::int32_t, int> firstGroups(const ModelMesh& mesh, GroupKind kind) {
  std::map<std::int32_t, int> first;
  int index = 0;
  for (const FaceGroup& group : mesh.groups) {
    if (group.kind != kind) continue;
    ++index;
    for (const int face : group.faces) first.try_emplace(face, index);
  }
  return first;
}

/// One array with a value for each cell: those of elements by slice and index there, then those of
/// lines.
template <class OfElement, class OfLine>
void cellArray(XmlOutput& file, const ArrayHead& head, const ModelMesh& mesh, Lines lines,
               OfElement ofElement, OfLine ofLine) {
  const std::size_t bytes = sizeof(ofElement(MeshSlice{}, std::size_t{}));
  dataArray(file, head, (elementCount(mesh) + lines.size()) * bytes, [&](auto& out) {
    forEachElement(mesh,
                   [&](const MeshSlice& slice, std::size_t e) { out.put(ofElement(slice, e)); });
    for (const LineElement& line : lines) out.put(ofLine(line));
  });
}

/// The same for values of elements that depend on their face only.
template <class OfFace, class OfLine>
void faceArray(XmlOutput& file, const ArrayHead& head, const ModelMesh& mesh, Lines lines,
               OfFace ofFace, OfLine ofLine) {
  const std::size_t bytes = sizeof(ofFace(std::int32_t{}));
  dataArray(file, head, (elementCount(mesh) + lines.size()) * bytes, [&](auto& out) {
    forEachRun(mesh, [&](const ElementRun& run) {
      const auto value = ofFace(run.face);
      for (std::size_t i = 0; i < run.count; ++i) out.put(value);
    });
    for (const LineElement& line : lines) out.put(ofLine(line));
  });
}

/// For looking at: the solid of each element, and its colour. A face between two solids is shown
/// with the first one; the fields have it in both.
void writeGroupsOfCells(const ModelMesh& mesh, Lines lines, XmlOutput& file) {
  const auto groupAt = [](const std::map<std::int32_t, int>& first, std::int32_t face) {
    const auto found = first.find(face);
    return found == first.end() ? 0 : found->second;
  };
  const std::map<std::int32_t, int> solids = firstGroups(mesh, GroupKind::Solid);
  if (!solids.empty())
    faceArray(
        file, {"Int32", "solid"}, mesh, lines,
        [&](std::int32_t face) { return std::int32_t{groupAt(solids, face)}; },
        [](const LineElement&) { return std::int32_t{0}; });
  const std::map<std::int32_t, int> colors = firstGroups(mesh, GroupKind::Color);
  if (colors.empty()) return;
  using Rgb = std::array<std::uint8_t, 3>;
  std::vector<Rgb> values{{128, 128, 128}};  // of what has none
  for (const FaceGroup& group : mesh.groups) {
    if (group.kind != GroupKind::Color) continue;
    const unsigned long rgb = std::strtoul(group.name.c_str() + 1, nullptr, 16);
    values.push_back({static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8),
                      static_cast<std::uint8_t>(rgb)});
  }
  faceArray(
      file, {"UInt8", "color", 3}, mesh, lines,
      [&](std::int32_t face) { return values[static_cast<std::size_t>(groupAt(colors, face))]; },
      [&](const LineElement&) { return values.front(); });
}

void writeXmlCellData(const ModelMesh& mesh, Lines lines, XmlOutput& file) {
  file.text("<CellData Scalars=\"face\">\n");
  faceArray(
      file, {"Int32", "face"}, mesh, lines, [](std::int32_t face) { return face; },
      [](const LineElement&) { return kFaceOfLine; });
  cellArray(
      file, {"Int32", "rule"}, mesh, lines,
      [&](const MeshSlice& slice, std::size_t e) { return ruleNumber(slice.origins[e]); },
      [](const LineElement&) { return kNoRule; });
  cellArray(
      file, {"UInt8", "level"}, mesh, lines,
      [&](const MeshSlice& slice, std::size_t e) { return levelNumber(slice.origins[e]); },
      [](const LineElement&) { return kNoLevel; });
  if (hasScores(mesh))
    cellArray(
        file, {"Float32", "score"}, mesh, lines,
        [&](const MeshSlice& slice, std::size_t e) { return slice.scores[e]; },
        [](const LineElement&) { return kScoreOfLine; });
  cellArray(
      file, {"Float64", "quality"}, mesh, lines,
      [&](const MeshSlice& slice, std::size_t e) { return shapeQuality(slice, slice.elements[e]); },
      [](const LineElement&) { return kQualityOfLine; });
  if (!lines.empty()) {
    const auto ofNone = [](std::int32_t) { return kOnNoEdge; };
    faceArray(file, {"Int32", "edge"}, mesh, lines, ofNone,
              [](const LineElement& line) { return std::int32_t{line.edge}; });
    faceArray(file, {"Int32", "boundary"}, mesh, lines, ofNone,
              [](const LineElement& line) { return std::int32_t{line.boundary}; });
  }
  writeGroupsOfCells(mesh, lines, file);
  file.text("</CellData>\n");
}

}  // namespace

void writeVtu(const ModelMesh& mesh, const Extras& extras, OutputFile& output) {
  XmlOutput file{output, extras.compress};
  const Lines lines = extras.lines;
  file.text(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\"");
  if (extras.compress) file.text(" compressor=\"vtkZLibDataCompressor\"");
  file.text(">\n<UnstructuredGrid>\n");
  writeNames(mesh, file);
  file.text("<Piece NumberOfPoints=\"");
  file.number(vertexCount(mesh));
  file.text("\" NumberOfCells=\"");
  file.number(elementCount(mesh) + lines.size());
  file.text("\">\n");
  writePoints(mesh, file);
  writeXmlCells(mesh, lines, file);
  writePointData(mesh, file);
  writeXmlCellData(mesh, lines, file);
  file.text("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
}

}  // namespace af2::geometry
