// Tries one way after the other to fill a face, until one gives a sound mesh.
// Not installed.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

#include "engine/run/mesh_region.h"
#include "geometry/charts/chart_kind.h"
#include "geometry/charts/charted_surface.h"
#include "geometry/mesh/face_boundary.h"
#include "geometry/mesh/face_history.h"
#include "geometry/mesh/model_mesh.h"
#include "geometry/mesh/try_limits.h"
#include "geometry/sizes/finer_inside.h"

namespace af2::geometry {

/// A mesh of a face and how it was made.
struct FaceAttempt {
  MeshingResult result;
  ChartKind chart = ChartKind::Auto;               ///< used to fill the face; Auto: none
  std::unique_ptr<AF2LocalTransformMaker> charts;  ///< usable for optimising
  FillFault fault;
  std::vector<StuckPlace> stuck = {};  ///< where its front was stuck before it was closed
  bool isDrawnInParameters = false;    ///< then the front does not cross itself there
  bool chartsKnowOneSheet = false;     ///< `charts` know only one place of a vertex on a seam
  bool isOptimized = false;
  double optimizeShare = 0;    ///< of the time, if optimised
  std::size_t searchCost = 0;  ///< candidates of the front that were examined for it
};

/// The result of all the ways that were tried.
struct FilledFace {
  /// The best attempt; if all ways failed, an empty mesh with a fault that combines theirs.
  FaceAttempt attempt;
  FaceHistory history;                  ///< the ways that failed
  std::vector<MeshingResult> failures;  ///< their results, if all failed
  std::size_t searchCost = 0;           ///< of all ways together
};

/// Options for the mesh of a face.
struct FillOptions {
  ChartKind chart = ChartKind::Auto;
  bool optimize = true;
  QuadCleanUp quads = {};
  bool strictRules = false;  ///< only rules make elements, with the first chart
  std::stop_token stop = {};
  std::function<AF2MeshingObserver*()> observer;  ///< of each front
  RegionCrew* crew = nullptr;                     ///< who else meshes pieces of the face
};

/// The input for filling a face.
struct FaceTask {
  const ChartedSurface& surface;
  const FaceBoundary& boundary;
  const SizeField& size;
  double area = 0;  ///< to be filled; 0: unknown
  /// The number expected from the sizes inside; an upper bound if the area of the face is unknown.
  double expectedElements = 1;
  const AF2Algorithm& algorithm;
  const FillOptions& options;
  /// How many more elements than expected sizes inside may want.
  FinerInside finer = {};
  /// The limits of this try at the face.
  const TryLimits& limits;
  const ProgressCallback& progress;
  /// Makes charts and sizes of the face for another thread.
  const std::function<PieceTools(ChartKind)>& makeTools;
  /// Whether the expected number of elements takes all sizes inside into account: then a front that
  /// makes twice as many overlaps itself.
  bool knowsSizes = false;
  double areaBeside = 0;  ///< of what else the face gets: fans and layers
};

/// Goes through the table of ways (fill_ways.cpp) from the top.
FilledFace fillFace(const FaceTask& task);

/// Whether some vertex has two places in the parameters, as those on a seam do.
bool hasTwoSheets(const FrontInput& input);
/// Whether the boundary is a closed curve in the parameters, in which every vertex has one place.
bool hasOneSheet(const FaceTask& task);

}  // namespace af2::geometry
