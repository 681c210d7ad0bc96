// Which step of a run had a given edge of the mesh as its base edge.
#pragma once

#include <optional>

#include "cli/meshing/replay.h"

namespace af2::cli {

struct StepOfFace {
  int face = 0;
  std::size_t step = 0;  ///< in the face, from 1
};

/// Makes the run again. Vertices are numbers of the mesh, as in its files; they are followed
/// through the changes after the fronts. Of several steps at the edge, the last one.
///
/// face  only this face; 0: any
///
/// Nothing if no step of a front that was kept had this base edge. Throws UsageError if the mesh
/// has no such vertex.
std::optional<StepOfFace> stepAtEdge(const Replay& replay, const Trace& trace, int face,
                                     std::size_t from, std::size_t to);

}  // namespace af2::cli
