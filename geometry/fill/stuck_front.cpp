#include "geometry/fill/stuck_front.h"

#include <algorithm>
#include <utility>

#include "engine/base/place_text.h"
#include "geometry/fill/fill_limits.h"

namespace af2::geometry {

namespace {

/// Of the edges that tell why they were refused, the first one at the highest level. A front that
/// was stopped because it did not get on has others that might still match.
const StuckEdge& mostRefused(const std::vector<StuckEdge>& edges) {
  return *std::ranges::max_element(edges, {}, [](const StuckEdge& edge) {
    return std::pair(!edge.refusals.empty(), edge.level);
  });
}

}  // namespace

std::string stuckReason(const MeshingResult& result, const AF2Algorithm& algorithm) {
  std::string text =
      "the front got stuck with " + std::to_string(result.stuck.size()) + " edges left";
  if (result.stuck.empty()) return text;
  const StuckEdge& edge = mostRefused(result.stuck);
  text += ", one from " + textOf(result.mesh.vertices[edge.from.value].position) + " to " +
          textOf(result.mesh.vertices[edge.to.value].position);
  const RuleRefusal* farthest = nullptr;
  for (const RuleRefusal& refusal : edge.refusals)
    if (!farthest || refusal.reason > farthest->reason) farthest = &refusal;
  if (farthest)
    text += "; rule '" + algorithm.rules().rules()[farthest->rule].name() +
            "': " + toString(farthest->reason);
  return text;
}

std::vector<StuckPlace> stuckPlaces(const MeshingResult& result) {
  std::vector<StuckPlace> places;
  for (std::size_t i = 0; i < std::min(kMaxReportedPlaces, result.stuck.size()); ++i) {
    const StuckEdge& edge = result.stuck[i];
    const SurfacePoint& from = result.mesh.vertices[edge.from.value];
    StuckPlace& place = places.emplace_back();
    place.from = from.position;
    place.to = result.mesh.vertices[edge.to.value].position;
    place.u = from.u;
    place.v = from.v;
    place.level = edge.level;
    for (const RuleRefusal& refusal : edge.refusals)
      place.refusals.emplace_back(static_cast<std::uint16_t>(refusal.rule), refusal.reason);
    place.around = edge.around.piece;
  }
  return places;
}

}  // namespace af2::geometry
