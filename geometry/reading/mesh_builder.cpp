#include "geometry/reading/mesh_builder.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/error.h"
#include "geometry/faceted/polygon_triangles.h"

namespace af2::geometry {
namespace {

/// Numbers of sides are 32-bit: four for each element.
constexpr std::uint64_t kMostElements = std::uint64_t{1} << 30;

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// Larger numbers stay too large.
VertexId limited(std::uint64_t vertex) {
  constexpr std::uint64_t kMost = VertexId::kNone - 1;
  return VertexId(static_cast<std::uint32_t>(std::min(vertex, kMost)));
}

/// Leaves out corners that repeat the one before; returns how many are left.
std::size_t withoutRepetitions(Element& element) {
  std::vector<VertexId> left;
  for (const VertexId corner : element.vertices())
    if (left.empty() || (corner != left.back() && corner != left.front())) left.push_back(corner);
  element.corners.fill(VertexId());
  std::ranges::copy(left, element.corners.begin());
  return left.size();
}

}  // namespace

void MeshBuilder::addElement(std::span<const std::uint64_t> corners, std::int32_t face) {
  ModelMesh& mesh = result_.mesh;
  if (corners.size() > 4 && dividesPolygons_) {
    Polygon& polygon = polygons_.emplace_back(Polygon{{}, face});
    for (const std::uint64_t corner : corners) polygon.corners.push_back(limited(corner).value);
    return;
  }
  if (corners.size() < 3 || corners.size() > 4)
    fail("element " + std::to_string(mesh.elements.size() + 1) + " has " +
         std::to_string(corners.size()) + " corners; only triangles and quadrilaterals are read");
  if (mesh.elements.size() == kMostElements) fail("has more elements than AF2 can number");
  Element element{};
  for (std::size_t i = 0; i < corners.size(); ++i) element.corners[i] = limited(corners[i]);
  mesh.elements.push_back(element);
  mesh.face.push_back(face);
}

void MeshBuilder::addLine(std::uint64_t from, std::uint64_t to, std::int32_t edge) {
  result_.mesh.segments.push_back({limited(from), limited(to), edge, 1, {}});
}

void MeshBuilder::fail(const std::string& fault) const { throw InputError(name_ + ": " + fault); }

void MeshBuilder::checkNumbers() const {
  const ModelMesh& mesh = result_.mesh;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Point3& p = mesh.vertices[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      fail("vertex " + std::to_string(v) +
           " (counted from 0) has a coordinate that is not a finite number");
  }
  const auto check = [&](VertexId vertex, const char* what, std::size_t number) {
    if (vertex.value >= mesh.vertices.size())
      fail(std::string(what) + " " + std::to_string(number) +
           " (counted from 0) uses a vertex that the file does not have; it has " +
           std::to_string(mesh.vertices.size()) + " vertices");
  };
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (const VertexId corner : mesh.elements[e].vertices()) check(corner, "element", e);
  for (std::size_t i = 0; i < polygons_.size(); ++i)
    for (const std::uint32_t corner : polygons_[i].corners) check(VertexId(corner), "polygon", i);
  for (std::size_t i = 0; i < mesh.segments.size(); ++i)
    for (const VertexId end : {mesh.segments[i].from, mesh.segments[i].to}) check(end, "line", i);
}

void MeshBuilder::addTrianglesOfPolygons() {
  ModelMesh& mesh = result_.mesh;
  for (const Polygon& polygon : polygons_)
    for (const auto& [a, b, c] : trianglesOfPolygon(mesh.vertices, polygon.corners))
      addElement(std::array<std::uint64_t, 3>{a, b, c}, polygon.face);
  if (!polygons_.empty())
    mesh.notes.push_back("divided into triangles: " + counted(polygons_.size(), "polygon") +
                         " with more than four corners");
}

void MeshBuilder::mendElements() {
  ModelMesh& mesh = result_.mesh;
  std::size_t kept = 0, collapsed = 0, mended = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    Element element = mesh.elements[e];
    if (!hasProperCorners(element, mesh.vertices.size())) {
      const bool isSound =
          withoutRepetitions(element) >= 3 && hasProperCorners(element, mesh.vertices.size());
      ++(isSound ? mended : collapsed);
      if (!isSound) continue;
    }
    mesh.face[kept] = mesh.face[e];
    mesh.elements[kept++] = element;
  }
  mesh.elements.resize(kept);
  mesh.face.resize(kept);
  writeNotes(collapsed, mended);
}

void MeshBuilder::writeNotes(std::size_t collapsed, std::size_t mended) {
  std::vector<std::string>& notes = result_.mesh.notes;
  if (isSecondOrder_)
    notes.push_back("the elements have second order; only their corners are read");
  for (const auto& [kind, count] : leftOut_)
    notes.push_back("left out: " + counted(count, "element") + " that AF2 does not read: " + kind);
  if (mended > 0)
    notes.push_back("read as triangles: " + counted(mended, "quadrilateral") +
                    " with two equal corners");
  if (collapsed > 0)
    notes.push_back("left out: " + counted(collapsed, "element") +
                    " with a vertex that is used twice");
}

void MeshBuilder::dropWrongSizes() {
  ModelMesh& mesh = result_.mesh;
  const bool isRight = mesh.wantedSizes.size() == mesh.vertices.size() &&
                       std::ranges::all_of(mesh.wantedSizes, [](double size) {
                         return std::isfinite(size) && size > 0;
                       });
  if (isRight || mesh.wantedSizes.empty()) return;
  mesh.wantedSizes.clear();
  mesh.notes.push_back(
      "the array wanted_size is not used, because it does not have a positive number for each "
      "vertex");
}

void MeshBuilder::countFaces() {
  std::map<std::int32_t, std::size_t> counts;
  for (const std::int32_t face : result_.mesh.face) ++counts[face];
  for (const auto& [face, count] : counts) {
    FaceReport report;
    report.id = face;
    report.elements = count;
    if (const auto name = faceNames_.find(face); name != faceNames_.end())
      report.name = name->second;
    result_.mesh.faces.push_back(std::move(report));
  }
}

MeshFile MeshBuilder::finish() {
  ModelMesh& mesh = result_.mesh;
  checkNumbers();
  addTrianglesOfPolygons();
  mendElements();
  if (mesh.elements.empty())
    fail(leftOut_.empty() ? "contains no elements; give a mesh of triangles or quadrilaterals"
                          : "contains no triangles or quadrilaterals, only " +
                                leftOut_.begin()->first + "; give a mesh of a surface");
  if (!result_.hasFaces) std::ranges::fill(mesh.face, 1);
  dropWrongSizes();
  countFaces();
  mesh.name = std::filesystem::path(name_).filename().string();
  mesh.origins.assign(mesh.elements.size(), ElementOrigin{0, 0, true});
  return std::move(result_);
}

void MeshBuilder::finishField() {
  checkNumbers();
  const ModelMesh& mesh = result_.mesh;
  const auto add = [&](std::span<const VertexId> vertices, int dimension) {
    std::vector<std::uint64_t> corners;
    for (const VertexId vertex : vertices) corners.push_back(vertex.value);
    field_->add(corners, dimension);
  };
  for (const Element& element : mesh.elements) add(element.vertices(), 2);
  for (const EdgeSegment& segment : mesh.segments) add(std::array{segment.from, segment.to}, 1);
  for (const auto& cell : field_->cells)
    for (const std::uint64_t corner : cell)
      if (corner != FieldCells::kNoCorner && corner >= mesh.vertices.size())
        fail("a cell uses a vertex that the file does not have");
  field_->vertices = mesh.vertices;
}

}  // namespace af2::geometry
