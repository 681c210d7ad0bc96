#include "geometry/fill/closing_way.h"

#include <utility>

#include "engine/base/work_watch.h"
#include "engine/mesh/mesh_check.h"
#include "engine/optimize/turn_round.h"
#include "geometry/fill/close_front.h"
#include "geometry/fill/stuck_front.h"
#include "geometry/mesh/without_rule.h"

namespace af2::geometry {

namespace {

/// Parameters, scaled so that both have about the same unit of length, and mirrored if need be.
struct ScaledParameters {
  double u = 1, v = 1;
};

ScaledParameters scaleOf(const ParametricSurface& surface, const MeshingResult& result) {
  double du = 0, dv = 0;
  for (const StuckEdge& edge : result.stuck) {
    const SurfacePoint& p = result.mesh.vertices[edge.from.value];
    const auto frame = surface.frameAt(p.u, p.v);
    du += length(frame.du);
    dv += length(frame.dv);
  }
  const auto count = static_cast<double>(result.stuck.size());
  return {du / count, (surface.isFlipped() ? -1 : 1) * dv / count};
}

bool closeInParameters(const FaceTask& task, const MeshingResult& stuck, ElementOrigin origin,
                       std::size_t maxEdges, MeshingResult& closed) {
  const auto& vertices = stuck.mesh.vertices;
  const ScaledParameters scale = scaleOf(*task.surface.inParameters(), stuck);
  const auto inPlane = [&](VertexId v) {
    return Point2{scale.u * vertices[v.value].u, scale.v * vertices[v.value].v};
  };
  return closeFront(closed, inPlane, origin, maxEdges);
}

}  // namespace

bool closeStuck(const FaceTask& task, FaceAttempt& attempt, std::size_t maxEdges) {
  if (attempt.result.outcome != Outcome::Stuck || attempt.result.stuck.empty()) return false;
  MeshingResult closed = attempt.result;
  const ElementOrigin origin = originOf(WithoutRule::Closing, task.algorithm.rules());
  const bool inParameters = attempt.isDrawnInParameters && !hasTwoSheets(task.boundary.input);
  const bool isClosed = inParameters
                            ? closeInParameters(task, attempt.result, origin, maxEdges, closed)
                            : closeFront(closed, origin, maxEdges);
  if (!isClosed) return false;
  const MeshBoundary boundary = af2::boundaryOf(task.boundary.input);
  if (attempt.charts && hasTurnedElements(closed.mesh))  // they waited until the mesh is complete
    turnElementsRound(closed.mesh, boundary, *attempt.charts, WorkWatch(task.options.stop));
  if (!faultOf(closed.mesh, boundary).empty()) return false;
  attempt.stuck = stuckPlaces(attempt.result);
  attempt.result = std::move(closed);
  attempt.fault = {};
  return true;
}

FaceAttempt fillByClosing(FillState& state) {
  for (FaceAttempt& attempt : state.failed) {
    if (!closeStuck(state.task, attempt, kMaxStuckEdges)) continue;
    attempt.searchCost = 0;  // it is counted already
    return std::move(attempt);
  }
  FaceAttempt none;
  none.fault.kind = FillFaultKind::NotFilled;
  return none;
}

}  // namespace af2::geometry
