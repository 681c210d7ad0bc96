#include "geometry/occ/face_attempt.h"

#include <algorithm>

#include "engine/mesh_check.h"
#include "geometry/close_front.h"
#include "geometry/occ/chart_attempt.h"
#include "geometry/occ/face_trouble.h"

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

/// Closes the front of a stuck attempt, if the result is sound.
bool close(const FaceTask& task, FaceAttempt& attempt) {
  if (attempt.result.outcome != Outcome::Stuck || attempt.result.stuck.empty()) return false;
  MeshingResult closed = attempt.result;
  const auto& vertices = attempt.result.mesh.vertices;
  const auto rule = static_cast<std::uint16_t>(task.algorithm.rules().rules().size());
  const bool inParameters =
      (attempt.chart == ChartKind::Parametric || attempt.chart == ChartKind::Affine ||
       attempt.chart == ChartKind::Developed) &&
      !hasTwoSheets(task.boundary.input);
  bool done = false;
  if (inParameters) {
    const ScaledParameters scale = scaleOf(task.surface.inParameters(), closed);
    done = closeFront(
        closed,
        [&](VertexId v) {
          return Point2{scale.u * vertices[v.value].u, scale.v * vertices[v.value].v};
        },
        rule);
  } else {
    done = closeFront(closed, rule);
  }
  if (!done || !faultOf(closed.mesh, af2::boundaryOf(task.boundary.input)).empty()) return false;
  attempt.closingElements = closed.mesh.elements.size() - attempt.result.mesh.elements.size();
  attempt.result = std::move(closed);
  attempt.fault.clear();
  return true;
}

/// The kinds of charts to try, best first: that asked for, then those that suit the surface.
std::vector<ChartKind> chartsFor(const FaceTask& task) {
  const auto isPossible = [&](ChartKind kind) {
    const bool isInParameters = kind == ChartKind::Parametric || kind == ChartKind::Affine ||
                                kind == ChartKind::Developed || kind == ChartKind::Conformal;
    return (!isInParameters || task.boundary.closedInParameters) && task.surface.has(kind);
  };
  std::vector<ChartKind> kinds;
  const auto add = [&](ChartKind kind) {
    if (isPossible(kind) && std::ranges::find(kinds, kind) == kinds.end()) kinds.push_back(kind);
  };
  if (task.options.chart != ChartKind::Auto) add(task.options.chart);
  for (const ChartKind kind : {ChartKind::Plane, ChartKind::Developed, ChartKind::Stereographic,
                               ChartKind::Conformal, ChartKind::MeanNormal})
    add(kind);
  if (!isPossible(ChartKind::Developed))
    add(isPossible(ChartKind::Affine) ? ChartKind::Affine : ChartKind::NormalLines);
  return kinds;
}

FaceAttempt fillWithRules(const FaceTask& task) {
  const std::vector<ChartKind> kinds = chartsFor(task);
  std::vector<FaceAttempt> failed;
  std::vector<std::string> steps;
  std::size_t effort = 0;
  constexpr int kPatience = 4;  // as long as there is another way to try
  for (const ChartKind kind : kinds) {
    FaceAttempt attempt = attemptWith(task, kind, kind == kinds.back() ? 0 : kPatience);
    effort += attempt.result.candidates;
    if (attempt.fault.empty()) {
      attempt.effort = effort;
      attempt.steps = std::move(steps);
      return attempt;
    }
    steps.push_back(std::string(toString(kind)) + " charts: " + attempt.fault);
    failed.push_back(std::move(attempt));
  }
  for (FaceAttempt& attempt : failed) {
    if (!close(task, attempt)) continue;
    attempt.effort = effort;
    attempt.steps = std::move(steps);
    return std::move(attempt);
  }
  FaceAttempt all;
  for (const std::string& step : steps) all.fault += (all.fault.empty() ? "" : "; ") + step;
  all.effort = effort;
  all.steps = std::move(steps);
  for (FaceAttempt& attempt : failed) all.failures.push_back(std::move(attempt.result));
  return all;
}

/// How many times too large or too small the area of a mesh is, at least 1.
double areaError(const FaceTask& task, const FaceAttempt& attempt) {
  const double area = areaOfElements(attempt.result.mesh);
  return std::max(area / task.area, task.area / area);
}

bool isNearArea(const FaceTask& task, const FaceAttempt& attempt) {
  constexpr double kNear = 1.25;
  return task.surface.isPlane() || !(task.area > 0) || areaError(task, attempt) < kNear;
}

FaceAttempt fillWithoutVertices(const FaceTask& task) {
  FaceAttempt attempt;
  attempt.chart = ChartKind::Parametric;
  attempt.charts = task.surface.makeCharts(ChartKind::MeanNormal);
  attempt.fault = "not filled";
  if (!task.boundary.closedInParameters || hasTwoSheets(task.boundary.input)) return attempt;
  attempt.result.outcome = Outcome::Stuck;
  attempt.result.mesh.vertices.resize(task.boundary.input.vertexCount);
  for (const auto& loop : task.boundary.input.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const BoundaryCorner& corner = loop[i];
      attempt.result.mesh.vertices[corner.vertex.value] = corner.point;
      attempt.result.stuck.push_back({corner.vertex, loop[(i + 1) % loop.size()].vertex, 1, {}});
    }
  }
  close(task, attempt);
  attempt.chart = ChartKind::Auto;  // it took none
  return attempt;
}

}  // namespace

bool hasTwoSheets(const FrontInput& input) {
  std::vector<const SurfacePoint*> seen(input.vertexCount, nullptr);
  for (const auto& loop : input.loops) {
    for (const BoundaryCorner& corner : loop) {
      const SurfacePoint*& first = seen[corner.vertex.value];
      if (first && (first->u != corner.point.u || first->v != corner.point.v)) return true;
      first = &corner.point;
    }
  }
  return false;
}

FaceAttempt fillFace(const FaceTask& task) {
  FaceAttempt filled = fillWithRules(task);
  if (!filled.fault.empty() || isNearArea(task, filled)) return filled;
  FaceAttempt bare = fillWithoutVertices(task);
  return bare.fault.empty() && areaError(task, bare) < areaError(task, filled) ? std::move(bare)
                                                                               : std::move(filled);
}

}  // namespace af2::geometry
