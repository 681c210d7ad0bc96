// Meshes one region from boundary to finished mesh, with as many threads as the caller's arena.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/base/export.h"
#include "engine/optimize/optimize.h"
#include "engine/run/algorithm.h"
#include "engine/run/region_split.h"

namespace af2 {

/// The tools for one piece, which threads must not share. Each may refer to the other, so they have
/// the same lifetime.
struct PieceTools {
  std::unique_ptr<AF2LocalTransformMaker> charts;
  std::shared_ptr<const SizeField> size;
};

struct RegionMesh {
  MeshingResult result;
  std::string fault;           ///< what is wrong with the mesh; empty: it is sound
  double optimizeSeconds = 0;  ///< summed over threads
  double seconds = 0;          ///< total, likewise summed over threads
  Progress progress = {};      ///< the last that its front reported
};

/// Others that mesh pieces of a region, too, such as processes that have the same task.
class RegionCrew {
 public:
  using MeshPiece = std::function<RegionMesh(std::size_t piece)>;
  using TakePiece = std::function<void(std::size_t piece, RegionMesh mesh)>;

  virtual ~RegionCrew() = default;
  /// Meshes the pieces of a region that is cut. Calls `take` once for each of them, from any
  /// thread. Returns false if the region is another process's, which gets what was meshed here.
  ///
  /// work  by piece: the expected number of elements
  /// mesh  meshes a piece in this process; may be called from several threads at once
  virtual bool meshPieces(const std::vector<double>& work, const MeshPiece& mesh,
                          const TakePiece& take) = 0;
};

/// A region and the surface on which it lies.
struct RegionTask {
  const FrontInput& input;
  /// Must be callable from several threads at once.
  std::function<PieceTools()> makeTools;
  /// Null: the region is not cut.
  const SurfaceEvaluator* surface = nullptr;
  SplitOptions split = {};
  bool optimize = true;  ///< false: the mesh stays as the front made it, whatever the rule set says
  int threads = 0;       ///< maximum; 0: as many as the caller's TBB arena has
  QuadCleanUp quads = {};
  RegionCrew* crew = nullptr;  ///< null: the threads of this process mesh all pieces
};

/// Cuts the region if it is large, meshes the pieces in parallel, optimises them and the strips
/// where they meet, and checks the result. The mesh depends only on the task, not on the number of
/// threads. The progress callback is called from several threads, one call at a time.
///
/// Throws the exceptions of AF2Algorithm::execute.
AF2_EXPORT RegionMesh meshRegion(const AF2Algorithm& algorithm, const RegionTask& task,
                                 const FrontOptions& options);

}  // namespace af2
