// Meshes one region from boundary to finished mesh, on as many threads as the caller's arena has.
#pragma once

#include <functional>
#include <memory>

#include "engine/base/export.h"
#include "engine/run/algorithm.h"
#include "engine/run/region_split.h"

namespace af2 {

/// What one piece needs for itself: neither is shared between threads. Each may refer to the other;
/// they go together.
struct PieceTools {
  std::unique_ptr<AF2LocalTransformMaker> charts;
  std::shared_ptr<const SizeField> size;
};

/// A region and what it lies on.
struct RegionTask {
  const FrontInput& input;
  /// Must be callable from several threads at once.
  std::function<PieceTools()> makeTools;
  /// Null: the region is not cut.
  const SurfaceEvaluator* surface = nullptr;
  SplitOptions split = {};
  bool optimize = true;
  int threads = 0;  ///< at most so many; 0: as many as the caller's TBB arena has
};

struct RegionMesh {
  MeshingResult result;
  std::string fault;           ///< what is wrong with the mesh; empty: it is sound
  double optimizeSeconds = 0;  ///< summed over threads
  double seconds = 0;          ///< likewise, in all
};

/// Cuts the region where it is large, meshes the pieces at the same time, optimises them and the
/// lines where they meet, and checks all of it. The mesh depends on the task alone, not on the
/// number of threads; the progress callback is called from several threads, one at a time.
///
/// Throws what AF2Algorithm::execute throws.
AF2_EXPORT RegionMesh meshRegion(const AF2Algorithm& algorithm, const RegionTask& task,
                                 const MeshingOptions& options);

}  // namespace af2
