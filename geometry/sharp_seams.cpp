#include "geometry/sharp_seams.h"

namespace af2::geometry {
namespace {

/// A vertex as it is seen on one side of a seam.
struct Side {
  VertexId vertex;
  Point3 normal;
};

}  // namespace

void partSharpSeams(FrontInput& input, std::vector<std::uint32_t>& points) {
  std::vector<std::vector<Side>> sides(input.vertexCount);
  const auto idOf = [&](const BoundaryCorner& corner) {
    std::vector<Side>& known = sides[corner.vertex.value];
    for (const Side& side : known)
      if (!differSharply(side.normal, corner.point.normal)) return side.vertex;
    VertexId id = corner.vertex;
    if (!known.empty()) {
      id = VertexId(points.size());
      points.push_back(points[corner.vertex.value]);
    }
    known.push_back({id, corner.point.normal});
    return id;
  };
  for (auto& loop : input.loops)
    for (BoundaryCorner& corner : loop) corner.vertex = idOf(corner);
  input.vertexCount = points.size();
}

}  // namespace af2::geometry
