#include "geometry/fill/ignoring_normals_way.h"

#include <algorithm>
#include <utility>

#include "engine/mesh/mesh_check.h"
#include "geometry/fill/boundary_alone_way.h"
#include "geometry/fill/chart_way.h"
#include "geometry/fill/close_front.h"
#include "geometry/fill/closing_way.h"
#include "geometry/fill/fill_limits.h"
#include "geometry/fill/stuck_front.h"
#include "geometry/fill/without_normals.h"
#include "geometry/mesh/without_rule.h"

namespace af2::geometry {

namespace {

/// Whether a mesh fills the region that the boundary encloses, whatever the tilt of its elements.
bool isFilled(const FaceTask& task, Mesh mesh) {
  for (SurfacePoint& vertex : mesh.vertices) vertex.normal = {};
  return faultOf(mesh, af2::boundaryOf(task.boundary.input)).empty();
}

/// Closes what is left of a front across its small loops, each in a plane of its own.
bool closeAcrossLoops(const FaceTask& task, FaceAttempt& attempt) {
  if (attempt.result.outcome != Outcome::Stuck) return false;
  MeshingResult closed = attempt.result;
  if (!closeLoops(closed, originOf(WithoutRule::Closing, task.algorithm.rules()))) return false;
  if (!isFilled(task, closed.mesh)) return false;
  attempt.stuck = stuckPlaces(attempt.result);
  attempt.result = std::move(closed);
  attempt.fault = {};
  attempt.isOptimized = true;  // the optimiser knows folds by the normals
  return isNearArea(task, attempt);
}

}  // namespace

bool canIgnoreNormalsInParameters(const FillState& state) {
  return !state.task.surface.isPlane() && hasOneSheet(state.task);
}

FaceAttempt fillIgnoringNormals(FillState& state) {
  const FaceTask& task = state.task;
  FaceAttempt attempt = attemptIgnoringNormals(task);
  if (!attempt.fault.isNone() && !closeStuck(task, attempt, kMaxStuckEdges)) return attempt;
  const ParametricSurface& surface = *task.surface.inParameters();
  if (!isFlatInParameters(attempt.result.mesh, surface.isFlipped()))
    attempt.fault.kind = FillFaultKind::FoldedInParameters;
  restoreNormals(surface, task.boundary.input, attempt.result.mesh);
  return attempt;
}

bool canCloseLoops(const FillState& state) {
  return isUnfilled(state) && !state.task.surface.isPlane() &&
         state.task.boundary.input.isolated.empty();
}

FaceAttempt fillAcrossLoops(FillState& state) {
  TryLimits limits = state.task.limits;
  limits.maxCandidates = std::min(limits.maxCandidates, kMaxCandidatesBeforeLoops);
  const FaceTask& given = state.task;
  const FaceTask task{
      given.surface,   given.boundary,   given.size,      given.area, given.expectedElements,
      given.algorithm, given.options,    given.finer,     limits,     given.progress,
      given.makeTools, given.knowsSizes, given.areaBeside};
  std::size_t searchCost = 0;
  for (const ChartTraits* chart : state.charts) {
    FaceAttempt attempt = attemptWith(task, *chart, 0);
    attempt.searchCost = searchCost += attempt.searchCost;
    if (closeAcrossLoops(task, attempt)) return attempt;
  }
  FaceAttempt bare;
  bare.searchCost = searchCost;
  bare.charts = given.surface.makeCharts(ChartKind::MeanNormal);
  bare.result = frontBeforeFirstStep(task.boundary.input);
  if (!closeAcrossLoops(task, bare)) bare.fault.kind = FillFaultKind::NotFilled;
  return bare;
}

}  // namespace af2::geometry
