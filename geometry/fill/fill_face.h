// One way after the other to fill a face, until one gives a sound mesh.
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
#include "geometry/mesh/try_limits.h"

namespace af2::geometry {

/// A mesh of a face and how it was made.
struct FaceAttempt {
  MeshingResult result;
  ChartKind chart = ChartKind::Auto;               ///< with which it was filled; Auto: with none
  std::unique_ptr<AF2LocalTransformMaker> charts;  ///< with which it may be optimised
  FillFault fault;
  bool isDrawnInParameters = false;  ///< so the front does not cross itself there
  bool chartsKnowOneSheet = false;   ///< `charts` see a vertex of a seam at one place only
  bool isOptimized = false;
  double optimizeShare = 0;         ///< of the time, if optimised
  std::size_t closingElements = 0;  ///< how many were made without a rule, to close a stuck front
  std::size_t searchCost = 0;       ///< candidates of the front that were examined for it
};

/// What came of all the ways that were tried.
struct FilledFace {
  /// The best one; if all ways failed, an empty mesh with the fault of all.
  FaceAttempt attempt;
  FaceHistory history;                  ///< the ways that failed
  std::vector<MeshingResult> failures;  ///< what these came to, if all failed
  std::size_t searchCost = 0;           ///< of all ways together
};

/// What is wanted of the mesh of a face.
struct FillOptions {
  ChartKind chart = ChartKind::Auto;
  bool optimize = true;
  std::stop_token stop = {};
  std::function<AF2MeshingObserver*()> observer;  ///< of each front
};

/// What is given for a face.
struct FaceTask {
  const ChartedSurface& surface;
  const FaceBoundary& boundary;
  const SizeField& size;
  double area = 0;  ///< of the face; 0: unknown
  /// That the sizes inside let expect, in the face or, if its area is not known, at most.
  double expectedElements = 1;
  const AF2Algorithm& algorithm;
  const FillOptions& options;
  /// Whether sizes inside may be much smaller than along the boundary.
  bool mayBeFineInside = false;
  /// Of this try at the face.
  const TryLimits& limits;
  const ProgressCallback& progress;
  /// Charts and sizes of the face for one thread more.
  const std::function<PieceTools(ChartKind)>& makeTools;
  /// Whether the expected elements are those of all sizes inside: a front that makes twice as many
  /// folds over.
  bool knowsSizes = false;
};

/// Goes through the table of ways (fill_ways.cpp) from the top.
FilledFace fillFace(const FaceTask& task);

/// Whether a vertex stands at two places of the parameters, as those of a seam do.
bool hasTwoSheets(const FrontInput& input);
/// Whether the boundary is a closed curve in the parameters, in which every vertex has one place.
bool hasOneSheet(const FaceTask& task);

}  // namespace af2::geometry
