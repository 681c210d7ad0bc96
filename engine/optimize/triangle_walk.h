// Turns triangles into quadrilaterals in pairs, however far apart they are.
#pragma once

#include "engine/base/work_watch.h"
#include "engine/optimize/patch_editor.h"

namespace af2 {

/// Moves triangles through quadrilaterals towards the nearest other triangle, until two of them
/// share a side and become one quadrilateral. Each step divides the triangle and the next element
/// differently and smooths the surroundings; it is taken only if all elements remain sound.
///
/// Nearby pairs come first. An odd number of triangles leaves one, and so does a region that is
/// divided by lines, in each part. Returns the number of pairs.
std::size_t walkTriangles(PatchEditor& editor, const WorkWatch& watch);

}  // namespace af2
