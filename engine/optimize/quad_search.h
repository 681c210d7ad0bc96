// Removes irregular vertices from meshes with quadrilaterals by sequences of small changes.
#pragma once

#include <vector>

#include "engine/base/work_watch.h"
#include "engine/optimize/patch_editor.h"

namespace af2 {

/// The results of sequences of acts that lower the energy of a patch, the best first; at most a
/// few. The first act is one at the first vertex of the patch or at an irregular vertex that was
/// touched.
///
/// depth  largest number of acts in a sequence
std::vector<QuadPatch> betterPatches(const QuadPatch& start, int depth);

/// Looks around each irregular vertex for a sequence of acts (see QuadPatch::Act) that leaves fewer
/// or less irregular vertices, smooths the surroundings, and keeps the result if its elements are
/// well shaped.
///
/// depth  largest number of acts in a sequence; shorter sequences are tried first everywhere
///
/// Returns the number of sequences that were applied. The same mesh gives the same result.
std::size_t searchQuads(PatchEditor& editor, int depth, const WorkWatch& watch);

/// How many irregular vertices are next to the boundary, each counted three times, or two edges
/// from it.
int irregularityAtBoundary(const QuadPatch& patch);

/// As betterPatches, but for sequences that lower irregularityAtBoundary and do not raise the
/// energy.
std::vector<QuadPatch> inwardPatches(const QuadPatch& start, int depth);

/// Moves irregular vertices away from the boundary, so that the rows along it are regular: each
/// moves once at most, together with others near it. Smooths and judges results as searchQuads
/// does.
///
/// Returns the number of sequences that were applied. The same mesh gives the same result.
std::size_t moveInward(PatchEditor& editor, int depth, const WorkWatch& watch);

}  // namespace af2
