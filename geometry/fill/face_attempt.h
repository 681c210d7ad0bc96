// One way after the other to fill a face, until one gives a sound mesh.
// Not installed.
#pragma once

#include <functional>
#include <memory>
#include <stop_token>
#include <string>

#include "engine/run/mesh_region.h"
#include "geometry/charts/chart_kind.h"
#include "geometry/charts/charted_surface.h"
#include "geometry/mesh/face_boundary.h"

namespace af2::geometry {

/// A mesh of a face and how it was made.
struct FaceAttempt {
  MeshingResult result;
  ChartKind chart = ChartKind::Auto;               ///< with which it was filled; Auto: with none
  std::unique_ptr<AF2LocalTransformMaker> charts;  ///< with which it may be optimised
  std::string fault;                               ///< empty: complete and sound, or cancelled
  bool isOptimized = false;
  double optimizeShare = 0;         ///< of the time, if optimised
  std::size_t closingElements = 0;  ///< how many were made without a rule, to close a stuck front
  std::vector<std::string> steps;   ///< what was tried before in vain, and why it failed
  std::vector<MeshingResult> failures;  ///< what these came to, if all failed
  std::size_t effort = 0;               ///< candidates of the front in all, those in vain too
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
  /// A front that has examined more candidates than these is given up.
  std::size_t mostCandidates;
  /// Whether elements may lean against the surface as they like: all else has failed.
  bool mayLean;
  const ProgressCallback& progress;
  /// Charts and sizes of the face for one thread more.
  const std::function<PieceTools(ChartKind)>& makeTools;
  /// Whether the expected elements are those of all sizes inside: a front that makes twice as many
  /// folds over.
  bool knowsSizes = false;
};

/// With the charts that were asked for, then with those that suit the surface, one kind after the
/// other; last, what is left of a stuck front is closed without rules. A curved strip
/// that is narrow against the sag of its segments is better filled without vertices inside.
FaceAttempt fillFace(const FaceTask& task);

/// Whether a vertex stands at two places of the parameters, as those of a seam do.
bool hasTwoSheets(const FrontInput& input);

}  // namespace af2::geometry
