// Closes the rest of a stuck front without new vertices.
#pragma once

#include <functional>
#include <vector>

#include "engine/run/algorithm.h"

namespace af2::geometry {

/// A front with more edges left is not just stuck at some place: its rules cannot mesh the region,
/// which must be reported rather than hidden.
inline constexpr std::size_t kMaxStuckEdges = 600;
/// The work grows with the square of this number.
inline constexpr std::size_t kMaxClosingEdges = 5000;

/// Triangulates the region to the left of the remaining front edges of `result`, with triangles of
/// any shape, and appends these with `origin`.
///
/// Rules make good elements and need room for them; in a sliver of a face, or where fronts have met
/// badly, there may be no room. But any region that is bounded by straight edges can be
/// triangulated from its corners.
///
/// inPlane  the place of a vertex in a plane in which the front does not cross itself
/// most     maximum number of edges of the front
///
/// Returns whether it succeeded; if not, `result` is unchanged. Geometric decisions in the plane
/// are exact.
bool closeFront(MeshingResult& result, const std::function<Point2(VertexId)>& inPlane,
                ElementOrigin origin, std::size_t most = kMaxStuckEdges);
/// The same in the plane perpendicular to the mean normal of the vertices that are left on the
/// front. Where that fails, each connected part of the front is closed in a plane of its own,
/// together with those inside it.
bool closeFront(MeshingResult& result, ElementOrigin origin, std::size_t most = kMaxStuckEdges);

/// The same for small loops, each in the plane perpendicular to its area vector, whatever the
/// direction of that. It does not check whether loops enclose each other, or whether the new
/// triangles overlap the rest of the mesh.
bool closeLoops(MeshingResult& result, ElementOrigin origin);

}  // namespace af2::geometry
