#include "geometry/fill/crossed_boundary.h"

#include <cstdint>
#include <optional>
#include <set>
#include <utility>

#include "engine/base/place_text.h"
#include "geometry/check/boundary_crossings.h"
#include "geometry/fill/boundary_alone_way.h"
#include "geometry/fill/diagnose_face.h"

namespace af2::geometry {

bool mayHaveCrossedBoundary(const FillState& state) {
  // The sides of a narrow strip cross where their segments are long: a front finds that out late.
  return state.task.surface.isPlane() && (state.task.limits.failedBefore || isNarrow(state.task));
}

FaceAttempt findCrossedBoundary(FillState& state) {
  const FrontInput& boundary = state.task.boundary.input;
  const BoundaryPicture picture(state.task.surface, boundary);
  const bool isCrossed = !crossingsOf(boundary, picture, 1).empty();
  FaceAttempt attempt;
  attempt.fault.kind = isCrossed ? FillFaultKind::CrossedBoundary : FillFaultKind::NotFilled;
  return attempt;
}

namespace {

/// The middle of a segment that the boundary uses twice in the same direction.
std::optional<Point3> doubledSegment(const FrontInput& boundary) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> used;
  for (const auto& loop : boundary.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const BoundaryCorner &from = loop[i], &to = loop[(i + 1) % loop.size()];
      if (!used.emplace(from.vertex.value, to.vertex.value).second)
        return 0.5 * (from.point.position + to.point.position);
    }
  return std::nullopt;
}

}  // namespace

std::string textOfCrossedBoundary(const ChartedSurface& surface, const FrontInput& boundary) {
  if (!surface.isPlane()) return "";
  if (const auto doubled = doubledSegment(boundary))
    return "its boundary runs back over itself near " + textOf(*doubled) + "; ";
  const auto crossings = crossingsOf(boundary, BoundaryPicture(surface, boundary), 1);
  if (crossings.empty()) return "";
  Point3 place;
  const auto [one, other] = crossings.front();
  for (const SegmentPlace& segment : {one, other}) {
    const auto& loop = boundary.loops[segment.loop];
    for (const std::size_t corner : {segment.corner, (segment.corner + 1) % loop.size()})
      place = place + 0.25 * loop[corner].point.position;
  }
  return "its boundary crosses itself near " + textOf(place) + ", as it is divided at this size; ";
}

}  // namespace af2::geometry
