#include "geometry/check/element_checker.h"

#include <algorithm>
#include <array>

namespace af2::geometry {

namespace {

/// A face without width has no elements, and no more than this share of the area of the mesh.
constexpr double kMaxWithoutWidth = 1e-4;

struct FacesArea {
  double area = 0;
  std::size_t elements = 0;
};

/// Complete faces of known area, by id; those that were meshed together are one.
std::map<int, FacesArea> areasOfFaces(const ModelMesh& mesh) {
  const MergedPatches patches(mesh);
  std::map<int, FacesArea> all;
  for (const FaceReport& face : mesh.faces) {
    if (face.status != FaceStatus::Complete || !(face.area > 0)) continue;
    FacesArea& some = all[patches.of(face.id)];
    some.area += face.area;
    some.elements += face.elements;
  }
  return all;
}

}  // namespace

std::uint32_t firstInside(const ModelMesh& mesh) {
  std::uint32_t first = 0;
  for (const EdgeSegment& segment : mesh.segments)
    first = std::max({first, segment.from.value + 1, segment.to.value + 1});
  return first;
}

void ElementChecker::checkElements() {
  double* area = nullptr;  // of the face
  for (std::size_t i = 0; i < mesh_.elements.size(); ++i) {
    if (i == 0 || mesh_.face[i] != mesh_.face[i - 1]) {
      area = &areas_[patches_.of(mesh_.face[i])];
      insides_.emplace_back();
    }
    if (!hasProperCorners(mesh_.elements[i], mesh_.vertices.size())) {
      addUnsound(i);
      continue;
    }
    *area += checkedArea(i);
    noteInside(i);
  }
}

std::optional<std::uint32_t> ElementChecker::firstInside() const {
  if (!unsound_.empty()) return std::nullopt;
  std::vector<Range> insides = insides_;
  std::erase_if(insides, [](const Range& inside) { return inside.low > inside.high; });
  std::ranges::sort(insides, {}, &Range::low);
  const auto meet = [](const Range& a, const Range& b) { return a.high >= b.low; };
  if (std::ranges::adjacent_find(insides, meet) != insides.end()) return std::nullopt;
  return firstInside_;
}

std::vector<std::size_t> ElementChecker::sound() const {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < mesh_.elements.size(); ++i)
    if (!std::ranges::binary_search(unsound_, i)) all.push_back(i);
  return all;
}

void ElementChecker::addUnsound(std::size_t i) {
  unsound_.push_back(i);
  for (const VertexId v : mesh_.elements[i].vertices())
    if (v.value >= mesh_.vertices.size())
      return findings_.add({mesh_.face[i], "an element has a corner that is not a vertex", {}});
  std::array<VertexId, 4> corners = mesh_.elements[i].corners;
  std::ranges::sort(corners);
  const VertexId twice = *std::ranges::adjacent_find(corners);
  findings_.add({mesh_.face[i], "an element has a corner twice", position(twice)});
}

double ElementChecker::checkedArea(std::size_t i) {
  const auto& [a, b, c, d] = mesh_.elements[i].corners;
  const Point3& origin = position(a);
  const Point3 diagonal = position(c) - origin;
  Point3 sum = cross(position(b) - origin, diagonal);
  if (!d.isNone()) sum = sum + cross(diagonal, position(d) - origin);
  const double area = length(sum) / 2;
  if (!(area > 0)) findings_.add({mesh_.face[i], "an element has no area", origin});
  return area;
}

void ElementChecker::noteInside(std::size_t i) {
  int others = 0;
  for (const VertexId v : mesh_.elements[i].vertices()) {
    if (v.value < firstInside_) {
      ++others;
      continue;
    }
    Range& inside = insides_.back();
    inside.low = std::min(inside.low, v.value);
    inside.high = std::max(inside.high, v.value);
  }
  if (others > 1) atSegments_.push_back(i);
}

void checkAreas(const ModelMesh& mesh, std::map<int, double> areas, Findings& findings) {
  double whole = 0;
  for (const auto& [id, area] : areas) whole += area;
  for (const auto& [id, face] : areasOfFaces(mesh)) {
    if (!areas.contains(id) && face.area < kMaxWithoutWidth * whole) continue;
    const double ratio = areas[id] / face.area;
    if (!isWrongArea(ratio, face.elements)) continue;
    findings.add(
        {id, "the elements have " + std::to_string(ratio) + " times the area of the face", {}});
  }
}

}  // namespace af2::geometry
