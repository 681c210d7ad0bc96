#include "geometry/picture/drawn_mesh.h"

#include <algorithm>

#include "geometry/mesh/triangles_of.h"

namespace af2::geometry {
namespace {

using Side = DrawnTriangle::Side;

std::pair<VertexId, VertexId> ascending(VertexId a, VertexId b) { return std::minmax(a, b); }

/// Places on the outline of an element of second order, which has its corners at 0, 2, 4 ...
using Places = std::vector<std::array<std::size_t, 3>>;
const Places kCurvedTriangle{{0, 1, 5}, {1, 2, 3}, {5, 3, 4}, {1, 3, 5}};
const Places kCurvedQuad{{0, 1, 7}, {1, 2, 3}, {3, 4, 5}, {7, 5, 6}, {1, 3, 5}, {1, 5, 7}};

}  // namespace

DrawnMesh::DrawnMesh(const ModelMesh& mesh) : mesh_(mesh) {
  for (const EdgeSegment& segment : mesh.segments)
    outlines_.push_back(ascending(segment.from, segment.to));
  std::ranges::sort(outlines_);
}

bool DrawnMesh::isOutline(VertexId a, VertexId b) const {
  return std::ranges::binary_search(outlines_, ascending(a, b));
}

std::vector<DrawnSide> DrawnMesh::sidesOf(std::size_t element) const {
  std::vector<DrawnSide> sides;
  const auto corners = mesh_.elements[element].vertices();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const VertexId from = corners[i], to = corners[(i + 1) % corners.size()];
    const bool outline = isOutline(from, to);
    const VertexId middle = mesh_.midsides.empty() ? to : mesh_.midsides[element][i];
    sides.push_back({from, middle, outline});
    if (middle != to) sides.push_back({middle, to, outline});
  }
  return sides;
}

std::vector<DrawnTriangle> DrawnMesh::trianglesOf(std::size_t element) const {
  const std::vector<DrawnSide> sides = sidesOf(element);
  std::vector<DrawnTriangle> triangles;
  const auto sideBetween = [&](VertexId a, VertexId b) {
    const auto side =
        std::ranges::find_if(sides, [&](const DrawnSide& s) { return s.from == a && s.to == b; });
    if (side == sides.end()) return Side::Inside;
    return side->isOutline ? Side::Outline : Side::Side;
  };
  const auto add = [&](VertexId a, VertexId b, VertexId c) {
    triangles.push_back({{a, b, c}, {sideBetween(a, b), sideBetween(b, c), sideBetween(c, a)}});
  };
  if (mesh_.midsides.empty()) {
    for (const auto& [a, b, c] : geometry::trianglesOf(mesh_, mesh_.elements[element]))
      add(a, b, c);
  } else {
    for (const auto& [a, b, c] : sides.size() == 6 ? kCurvedTriangle : kCurvedQuad)
      add(sides[a].from, sides[b].from, sides[c].from);
  }
  return triangles;
}

std::vector<StuckPlace> stuckPlaces(const ModelMesh& mesh) {
  std::vector<StuckPlace> places;
  for (const FaceReport& face : mesh.faces)
    if (face.status == FaceStatus::Failed)
      places.insert(places.end(), face.stuck.begin(), face.stuck.end());
  return places;
}

DrawnBox drawnBox(const ModelMesh& mesh) {
  std::vector<Point3> points = mesh.vertices;
  for (const StuckPlace& place : stuckPlaces(mesh))
    points.insert(points.end(), {place.from, place.to});
  if (points.empty()) return {};
  DrawnBox box{points.front(), points.front()};
  for (const Point3& p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  }
  return box;
}

}  // namespace af2::geometry
