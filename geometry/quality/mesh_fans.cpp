#include "geometry/quality/mesh_fans.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/base/elementary.h"
#include "geometry/base/disjoint_sets.h"
#include "geometry/quality/element_measures.h"

namespace af2::geometry {
namespace {

constexpr std::uint32_t kNothingAcross = 0xffffffffu;

std::uint32_t sizeAt(const ModelMesh& mesh, std::uint32_t corner) {
  return static_cast<std::uint32_t>(mesh.elements[corner / 4].size());
}
std::uint32_t nextCorner(const ModelMesh& mesh, std::uint32_t corner) {
  return corner % 4 + 1 < sizeAt(mesh, corner) ? corner + 1 : corner - corner % 4;
}
std::uint32_t previousCorner(const ModelMesh& mesh, std::uint32_t corner) {
  return corner % 4 > 0 ? corner - 1 : corner + sizeAt(mesh, corner) - 1;
}

/// The corner of the element at which its side between two vertices begins.
std::uint32_t sideOf(const ModelMesh& mesh, const MeshSide& side, VertexId lower) {
  const VertexId from = side.isForward() ? lower : VertexId(side.to);
  const auto& corners = mesh.elements[side.element()].corners;
  const auto at = std::ranges::find(corners, from) - corners.begin();
  return static_cast<std::uint32_t>(4 * side.element() + static_cast<std::size_t>(at));
}

Point3 normalOf(const ModelMesh& mesh, std::size_t element) {
  std::array<Point3, 4> points;
  const auto corners = mesh.elements[element].vertices();
  for (std::size_t i = 0; i < corners.size(); ++i) points[i] = mesh.vertices[corners[i].value];
  return unit(areaVector({points.data(), corners.size()}));
}

}  // namespace

MeshFans::MeshFans(const ModelMesh& mesh, double featureDegrees)
    : across_(4 * mesh.elements.size(), kNothingAcross) {
  joinElements(mesh, featureDegrees);
  numberRegions(mesh.elements.size());
  collectFans(mesh);
}

bool MeshFans::countEdge(const ModelMesh& mesh, std::span<const MeshSide> sides, bool isKept,
                         double leastCosine) {
  ++edges_.all;
  edges_.free += sides.size() == 1;
  edges_.nonManifold += sides.size() > 2;
  if (sides.size() != 2) return true;
  const std::size_t e = sides[0].element(), f = sides[1].element();
  const bool isTurned = sides[0].isForward() == sides[1].isForward();
  const double cosine = dot(normalOf(mesh, e), normalOf(mesh, f));
  const bool isBoundary =
      isKept || isTurned || mesh.face[e] != mesh.face[f] || cosine < leastCosine;
  edges_.turned += isTurned;
  edges_.folded += !isBoundary && cosine < 0;
  return isBoundary;
}

void MeshFans::joinElements(const ModelMesh& mesh, double featureDegrees) {
  std::vector<std::pair<VertexId, VertexId>> kept;
  for (const EdgeSegment& segment : mesh.segments)
    kept.push_back(std::minmax(segment.from, segment.to));
  std::ranges::sort(kept);
  const double leastCosine = cosine(featureDegrees * std::numbers::pi / 180);
  DisjointSets pieces(mesh.elements.size());
  MeshSides(mesh).forEachEdge([&](VertexId lower, std::span<const MeshSide> sides) {
    for (const MeshSide& side : sides)
      pieces.join(static_cast<std::uint32_t>(sides[0].element()),
                  static_cast<std::uint32_t>(side.element()));
    const std::pair ends(lower, VertexId(sides[0].to));
    if (countEdge(mesh, sides, std::ranges::binary_search(kept, ends), leastCosine)) {
      boundary_.push_back(ends);
      return;
    }
    const std::uint32_t one = sideOf(mesh, sides[0], lower), other = sideOf(mesh, sides[1], lower);
    across_[one] = other;
    across_[other] = one;
  });
  edges_.boundary = boundary_.size();
  for (std::uint32_t e = 0; e < mesh.elements.size(); ++e) components_ += pieces.of(e) == e;
}

void MeshFans::numberRegions(std::size_t elements) {
  DisjointSets sets(elements);
  for (std::uint32_t side = 0; side < across_.size(); ++side)
    if (across_[side] != kNothingAcross) sets.join(side / 4, across_[side] / 4);
  region_.resize(elements);
  for (std::uint32_t e = 0; e < elements; ++e) {
    const std::uint32_t first = sets.of(e);  // the lowest of its region, so numbered already
    region_[e] = first == e ? static_cast<std::uint32_t>(regions_++) : region_[first];
  }
}

void MeshFans::collectFans(const ModelMesh& mesh) {
  std::vector<bool> isTaken(across_.size(), false);
  const auto before = [&](std::uint32_t corner) {  // clockwise around the vertex
    return across_[corner] == kNothingAcross ? kNothingAcross : nextCorner(mesh, across_[corner]);
  };
  const auto after = [&](std::uint32_t corner) { return across_[previousCorner(mesh, corner)]; };
  for (std::uint32_t e = 0; e < mesh.elements.size(); ++e)
    for (std::uint32_t corner = 4 * e; corner < 4 * e + sizeAt(mesh, 4 * e); ++corner) {
      if (isTaken[corner]) continue;
      std::uint32_t first = corner;
      bool isClosed = false;
      for (std::uint32_t c = before(corner); c != kNothingAcross && !isClosed; c = before(c)) {
        first = c;
        isClosed = c == corner;
      }
      Fan fan{mesh.elements[e].corners[corner % 4], region_[e], isClosed, {}};
      for (std::uint32_t c = first; c != kNothingAcross && !isTaken[c]; c = after(c)) {
        isTaken[c] = true;
        fan.corners.push_back(c);
      }
      fans_.push_back(std::move(fan));
    }
}

}  // namespace af2::geometry
