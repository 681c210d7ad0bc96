#include "geometry/fill/boundary_alone_way.h"

#include <algorithm>
#include <array>

#include "engine/mesh/element_shape.h"
#include "geometry/fill/close_front.h"
#include "geometry/fill/closing_way.h"
#include "geometry/fill/diagnose_face.h"
#include "geometry/fill/fill_limits.h"

namespace af2::geometry {

namespace {

/// How many times too large or too small the area of a mesh is, at least 1.
double areaError(const FaceTask& task, const FaceAttempt& attempt) {
  const double area = areaOfElements(attempt.result.mesh);
  return std::max(area / task.area, task.area / area);
}

double worstDistortion(const FaceAttempt& attempt) {
  const Mesh& mesh = attempt.result.mesh;
  double worst = 0;
  for (const Element& element : mesh.elements) {
    std::array<const SurfacePoint*, 4> corners{};
    const auto vertices = element.vertices();
    for (std::size_t i = 0; i < vertices.size(); ++i)
      corners[i] = &mesh.vertices[vertices[i].value];
    worst = std::max(worst, elementDistortion({corners.data(), vertices.size()}));
  }
  return worst;
}

/// A place in a strip may be wider than the rest: edges across it are longer than those of the
/// boundary.
bool hasLongEdges(const FrontInput& boundary, const Mesh& mesh) {
  std::vector<double> longest(mesh.vertices.size(), 0);  // segment at a vertex
  for (const auto& loop : boundary.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const BoundaryCorner &from = loop[i], &to = loop[(i + 1) % loop.size()];
      const double segment = distance(from.point.position, to.point.position);
      for (const VertexId v : {from.vertex, to.vertex})
        longest[v.value] = std::max(longest[v.value], segment);
    }
  }
  return std::ranges::any_of(mesh.elements, [&](const Element& element) {
    const auto c = element.vertices();
    for (std::size_t i = 0; i < c.size(); ++i) {
      const auto from = c[i].value, to = c[(i + 1) % c.size()].value;
      const double edge = distance(mesh.vertices[from].position, mesh.vertices[to].position);
      if (edge > kLongAcross * std::max(longest[from], longest[to])) return true;
    }
    return false;
  });
}

}  // namespace

bool isNarrow(const FaceTask& task) {
  if (!(task.area > 0)) return false;
  const bool isPlane = task.surface.isPlane();
  if (!isPlane && (task.algorithm.rules().makesQuads() || !hasOneSheet(task))) return false;
  double perimeter = 0, segments = 0;
  for (const auto& loop : task.boundary.input.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i)
      perimeter += distance(loop[i].point.position, loop[(i + 1) % loop.size()].point.position);
    segments += static_cast<double>(loop.size());
  }
  const double width = 2 * task.area / perimeter;
  return width < (isPlane ? kNarrowStrip : kVeryNarrowStrip) * perimeter / segments;
}

bool isNearArea(const FaceTask& task, const FaceAttempt& attempt) {
  return task.surface.isPlane() || !(task.area > 0) || areaError(task, attempt) < kNearArea;
}

MeshingResult frontBeforeFirstStep(const FrontInput& boundary) {
  MeshingResult result;
  result.outcome = Outcome::Stuck;
  result.mesh.vertices.resize(boundary.vertexCount);
  for (const auto& loop : boundary.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      result.mesh.vertices[loop[i].vertex.value] = loop[i].point;
      result.stuck.push_back({loop[i].vertex, loop[(i + 1) % loop.size()].vertex, 1, {}, {}});
    }
  }
  return result;
}

bool needsNoVertices(const FillState& state) {
  const FaceTask& task = state.task;
  return task.boundary.input.isolated.empty() && !task.algorithm.rules().makesQuads() &&
         isNarrow(task);
}

bool mayNeedNoVertices(const FillState& state) {
  const FaceTask& task = state.task;
  const bool isPossible = task.surface.isPlane() || hasOneSheet(task);
  if (!isPossible || !task.boundary.input.isolated.empty()) return false;
  if (!needsNoVertices(state) && isNarrow(task)) return true;
  return state.best && !isNearArea(task, *state.best);
}

FaceAttempt fillFromBoundary(FillState& state) {
  const FaceTask& task = state.task;
  const bool isPlane = task.surface.isPlane();
  FaceAttempt attempt;
  attempt.charts = task.surface.makeCharts(isPlane ? ChartKind::Plane : ChartKind::MeanNormal);
  attempt.isDrawnInParameters = !isPlane;
  attempt.fault.kind = FillFaultKind::NotFilled;
  attempt.result = frontBeforeFirstStep(task.boundary.input);
  closeStuck(task, attempt, kMaxClosingEdges);
  attempt.stuck.clear();  // no front was advanced
  return attempt;
}

bool isBetterWithoutVertices(const FillState& state, const FaceAttempt& attempt) {
  const FaceTask& task = state.task;
  const bool isStrip = isNarrow(task);
  if (isStrip && hasLongEdges(task.boundary.input, attempt.result.mesh)) return false;
  // A curved strip may turn by more than its segments follow; then charts come first.
  if (!state.best) return !isStrip || !state.failed.empty() || isNearArea(task, attempt);
  return isStrip ? worstDistortion(attempt) < worstDistortion(*state.best)
                 : areaError(task, attempt) < areaError(task, *state.best);
}

}  // namespace af2::geometry
