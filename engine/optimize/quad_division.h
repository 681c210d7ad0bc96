// Divides quadrilaterals and triangles so that only quadrilaterals are left, or better ones.
#pragma once

#include <optional>
#include <span>

#include "engine/base/work_watch.h"
#include "engine/optimize/patch_editor.h"

namespace af2 {

/// The side of an element beyond which the other one lies; none if they share no side.
Corner sideTowards(const MeshTopology& topology, std::size_t e, std::size_t other);

/// Divides the quadrilaterals on the way from one triangle to another one lengthwise: each side on
/// the way gets a vertex in its middle, and where the way turns, the quadrilateral gets one as
/// well. Both triangles become quadrilaterals. If the way ends at a quadrilateral, that one is
/// divided into a quadrilateral and a triangle, which is nearer to the other triangle.
///
/// path           elements, each beside the next; the first one is a triangle, and the second one
///                a quadrilateral
/// beyond         the element that follows the path if it ends at a quadrilateral
/// leastJacobian  that the elements must have afterwards, or what they have now if that is less
///
/// Returns whether the elements could be divided; otherwise nothing is changed.
bool divideAlong(PatchEditor& editor, std::span<const std::size_t> path,
                 std::optional<std::size_t> beyond, double leastJacobian);

/// Replaces two triangles that share a side by a quadrilateral with four others around it. Their
/// outline may be straight at a vertex. See divideAlong for the rest.
bool divideInRing(PatchEditor& editor, std::size_t triangle, std::size_t beyond,
                  double leastJacobian);

/// Replaces a turned quadrilateral by another one with four around it, if that leaves fewer turned
/// elements. Returns whether it did.
bool divideTurned(PatchEditor& editor, std::size_t quad);

/// Does the same with quadrilaterals that are flat at a corner of which both sides are fixed, such
/// as those in tips: no vertex can move to make them better. Each must make its surroundings better
/// shaped. Returns the number of quadrilaterals that were divided.
std::size_t divideFlatQuads(PatchEditor& editor, const WorkWatch& watch);

}  // namespace af2
