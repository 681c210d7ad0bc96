#include "geometry/mesh/sharp_seams.h"

#include "geometry/base/turns.h"

namespace af2::geometry {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

/// A vertex as it is seen at a corner.
struct SeamSide {
  VertexId vertex;
  const SurfacePoint* point;
  std::uint32_t next = kNone;  ///< another side of the same vertex of the input
};

/// Corners of a vertex that are not on the same side get vertices of their own.
template <class IsSame>
void part(FrontInput& input, std::vector<std::uint32_t>& points, const IsSame& isSame) {
  std::vector<SeamSide> sides;
  std::vector<std::uint32_t> firstSide(input.vertexCount, kNone);
  const auto idOf = [&](const BoundaryCorner& corner) {
    std::uint32_t* place = &firstSide[corner.vertex.value];
    VertexId id = corner.vertex;
    for (; *place != kNone; place = &sides[*place].next) {
      if (isSame(*sides[*place].point, corner.point)) return sides[*place].vertex;
      id = VertexId(points.size());
    }
    if (id != corner.vertex) points.push_back(points[corner.vertex.value]);
    *place = static_cast<std::uint32_t>(sides.size());
    sides.push_back({id, &corner.point});
    return id;
  };
  std::size_t corners = 0;
  for (const auto& loop : input.loops) corners += loop.size();
  sides.reserve(corners);
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
