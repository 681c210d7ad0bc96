// Closes what is left of a front that got stuck, without new vertices.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "engine/run/algorithm.h"

namespace af2::geometry {

/// A front with more edges left is not merely stuck somewhere: its rules are not equal to the
/// region, which must be told rather than hidden.
inline constexpr std::size_t kMostStuckEdges = 600;
/// The work grows with the second power.
inline constexpr std::size_t kMostClosingEdges = 5000;

/// What stands in the place of the rule's number where an element was made without rules.
inline std::uint16_t closingRule(const RuleSet& rules) {
  return static_cast<std::uint16_t>(rules.rules().size());
}

/// Triangulates the region to the left of the front edges that are left in `result`, whatever the
/// shape of its triangles, and appends them with `rule` as the rule that made them.
///
/// The rules of a rule set make good elements, and need room for them; in a sliver of a face, or
/// where fronts have met badly, there may be none. Any region that is bounded by straight edges can
/// be triangulated from its corners, though.
///
/// inPlane  where a vertex lies in a plane in which the front does not cross itself
/// most     edges of the front
///
/// Returns whether it succeeded; if not, `result` is unchanged. Decisions are exact in the plane.
bool closeFront(MeshingResult& result, const std::function<Point2(VertexId)>& inPlane,
                std::uint16_t rule, std::size_t most = kMostStuckEdges);
/// The same in the plane across the mean normal of the vertices that are left on the front.
bool closeFront(MeshingResult& result, std::uint16_t rule, std::size_t most = kMostStuckEdges);

/// The same for small loops, each in the plane that its area vector is across, whichever way that
/// leans. Nothing tells whether loops enclose each other, or whether what is closed lies on the
/// rest of the mesh.
bool closeLoops(MeshingResult& result, std::uint16_t rule);

}  // namespace af2::geometry
