#include "geometry/mesh/sharp_seams.h"

#include "geometry/base/turns.h"

namespace af2::geometry {
namespace {

/// A vertex as it is seen at a corner.
struct SeamSide {
  VertexId vertex;
  SurfacePoint point;
};

/// Corners of a vertex that are not on the same side get vertices of their own.
template <class IsSame>
void part(FrontInput& input, std::vector<std::uint32_t>& points, const IsSame& isSame) {
  std::vector<std::vector<SeamSide>> sides(input.vertexCount);
  const auto idOf = [&](const BoundaryCorner& corner) {
    std::vector<SeamSide>& known = sides[corner.vertex.value];
    for (const SeamSide& side : known)
      if (isSame(side.point, corner.point)) return side.vertex;
    VertexId id = corner.vertex;
    if (!known.empty()) {
      id = VertexId(points.size());
      points.push_back(points[corner.vertex.value]);
    }
    known.push_back({id, corner.point});
    return id;
  };
  for (auto& loop : input.loops)
    for (BoundaryCorner& corner : loop) corner.vertex = idOf(corner);
  input.vertexCount = points.size();
}

}  // namespace

void partSharpSeams(FrontInput& input, std::vector<std::uint32_t>& points) {
  part(input, points, [](const SurfacePoint& a, const SurfacePoint& b) {
    return !differSharply(a.normal, b.normal);
  });
}

void partSeams(FrontInput& input, std::vector<std::uint32_t>& points) {
  part(input, points,
       [](const SurfacePoint& a, const SurfacePoint& b) { return a.u == b.u && a.v == b.v; });
}

}  // namespace af2::geometry
