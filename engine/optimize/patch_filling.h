// Fills regions around irregular vertices anew, with the fewest irregular vertices.
#pragma once

#include "engine/base/work_watch.h"
#include "engine/optimize/patch_editor.h"

namespace af2 {

/// How far regions grow, and how many ways to fill them are tried.
struct FillingEffort {
  std::size_t elements, plans;
  int others, layers;  ///< irregular vertices towards which, and rings by which, a region grows
};

constexpr FillingEffort kGoodFilling{120, 3, 7, 6}, kBestFilling{160, 6, 12, 8};

/// Grows a region from each irregular vertex to other ones nearby until its outline has two to six
/// corners and no dents, and fills it with a grid or with one or two stars (see fillingPlans).
/// As in searchQuads, the result is smoothed and kept if it is well shaped and more regular.
///
/// Returns the number of regions. The same mesh gives the same result.
std::size_t fillPatches(PatchEditor& editor, const FillingEffort& effort, const WorkWatch& watch);

}  // namespace af2
