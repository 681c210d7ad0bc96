#include "geometry/fill/face_attempt.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

#include "engine/mesh/element_shape.h"
#include "engine/mesh/mesh_check.h"
#include "geometry/check/boundary_crossings.h"
#include "geometry/fill/chart_attempt.h"
#include "geometry/fill/close_front.h"
#include "geometry/fill/diagnose_face.h"
#include "geometry/fill/leaning_attempt.h"

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
///
/// most  edges of the front
bool close(const FaceTask& task, FaceAttempt& attempt, std::size_t most = kMostStuckEdges) {
  if (attempt.result.outcome != Outcome::Stuck || attempt.result.stuck.empty()) return false;
  MeshingResult closed = attempt.result;
  const auto& vertices = attempt.result.mesh.vertices;
  const std::uint16_t rule = closingRule(task.algorithm.rules());
  const bool inParameters =
      (attempt.chart == ChartKind::Parametric || attempt.chart == ChartKind::Affine ||
       attempt.chart == ChartKind::Developed) &&
      !hasTwoSheets(task.boundary.input);
  bool done = false;
  if (inParameters) {
    const ScaledParameters scale = scaleOf(*task.surface.inParameters(), closed);
    done = closeFront(
        closed,
        [&](VertexId v) {
          return Point2{scale.u * vertices[v.value].u, scale.v * vertices[v.value].v};
        },
        rule, most);
  } else {
    done = closeFront(closed, rule, most);
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
    const bool hasParameters = task.surface.inParameters() && task.boundary.closedInParameters;
    return (!isInParameters || hasParameters) && task.surface.has(kind);
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

/// Whether the boundary can be drawn in the parameters.
bool hasOneSheet(const FaceTask& task) {
  return task.surface.inParameters() && task.boundary.closedInParameters &&
         !hasTwoSheets(task.boundary.input);
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

bool isNearArea(const FaceTask& task, const FaceAttempt& attempt) {
  constexpr double kNear = 1.25;
  return task.surface.isPlane() || !(task.area > 0) || areaError(task, attempt) < kNear;
}

/// The front is all of the boundary, as it is before the first step.
void beginFront(const FrontInput& boundary, MeshingResult& result) {
  result.outcome = Outcome::Stuck;
  result.mesh.vertices.resize(boundary.vertexCount);
  for (const auto& loop : boundary.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      result.mesh.vertices[loop[i].vertex.value] = loop[i].point;
      result.stuck.push_back({loop[i].vertex, loop[(i + 1) % loop.size()].vertex, 1, {}});
    }
  }
}

FaceAttempt fillWithoutVertices(const FaceTask& task) {
  const bool isPlane = task.surface.isPlane();
  FaceAttempt attempt;
  attempt.chart = isPlane ? ChartKind::Plane : ChartKind::Parametric;
  attempt.charts = task.surface.makeCharts(isPlane ? ChartKind::Plane : ChartKind::MeanNormal);
  attempt.fault = "not filled";
  const bool isPossible = isPlane || hasOneSheet(task);
  if (!isPossible || !task.boundary.input.isolated.empty()) return attempt;
  beginFront(task.boundary.input, attempt.result);
  close(task, attempt, kMostClosingEdges);
  attempt.chart = ChartKind::Auto;  // it took none
  return attempt;
}

/// Elements lean against the surface as far as they like, as long as nothing folds in the
/// parameters.
FaceAttempt fillLeaningInParameters(const FaceTask& task) {
  FaceAttempt attempt;
  attempt.fault = "not filled";
  if (task.surface.isPlane() || !hasOneSheet(task)) return attempt;
  attempt = attemptLeaning(task);
  attempt.effort = attempt.result.candidates;
  if (!attempt.fault.empty() && !close(task, attempt)) return attempt;
  const ParametricSurface& surface = *task.surface.inParameters();
  if (!isFlatInParameters(attempt.result.mesh, surface.isFlipped()))
    attempt.fault = "elements fold in the parameters";
  restoreNormals(surface, task.boundary.input, attempt.result.mesh);
  return attempt;
}

/// Whether a mesh fills what the boundary encloses, however its elements lean.
bool isFilled(const FaceTask& task, Mesh mesh) {
  for (SurfacePoint& vertex : mesh.vertices) vertex.normal = {};
  return faultOf(mesh, af2::boundaryOf(task.boundary.input)).empty();
}

/// Closes what is left of a front across its small loops, each in a plane of its own.
bool closeLeaning(const FaceTask& task, FaceAttempt& attempt) {
  if (attempt.result.outcome != Outcome::Stuck) return false;
  MeshingResult closed = attempt.result;
  if (!closeLoops(closed, closingRule(task.algorithm.rules()))) return false;
  if (!isFilled(task, closed.mesh)) return false;
  attempt.closingElements = closed.mesh.elements.size() - attempt.result.mesh.elements.size();
  attempt.result = std::move(closed);
  attempt.fault.clear();
  attempt.isOptimized = true;  // the optimiser knows folds by the normals
  return isNearArea(task, attempt);
}

/// A patch where fillets meet may be bent more than its few elements can follow: there the front
/// leaves little, across which only its edges tell how elements should lie; or nothing fits at all.
FaceAttempt fillAcross(const FaceTask& task) {
  constexpr std::size_t kMostCandidates = 300'000;  // a crammed front would leave much
  FaceTask limited = task;
  limited.mostCandidates = std::min(task.mostCandidates, kMostCandidates);
  std::size_t effort = 0;
  for (const ChartKind kind : chartsFor(task)) {
    FaceAttempt attempt = attemptWith(limited, kind, 0);
    effort += attempt.result.candidates;
    attempt.effort = effort;
    if (closeLeaning(task, attempt)) return attempt;
  }
  FaceAttempt bare;
  bare.effort = effort;
  beginFront(task.boundary.input, bare.result);
  if (!closeLeaning(task, bare)) bare.fault = "not filled";
  return bare;
}

FaceAttempt fillLeaning(const FaceTask& task) {
  FaceAttempt attempt = fillLeaningInParameters(task);
  if (attempt.fault.empty() || task.surface.isPlane() || !task.boundary.input.isolated.empty())
    return attempt;
  FaceAttempt across = fillAcross(task);
  const std::size_t effort = attempt.effort + across.effort;
  across.effort = attempt.effort = effort;
  return across.fault.empty() ? std::move(across) : std::move(attempt);
}

/// Whether a plane face is a strip, far narrower than its segments are long: vertices inside make
/// its elements only thinner.
bool isNarrow(const FaceTask& task) {
  constexpr double kNarrow = 0.3;  // width over length of a segment
  if (!task.surface.isPlane() || !(task.area > 0)) return false;
  double perimeter = 0, segments = 0;
  for (const auto& loop : task.boundary.input.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i)
      perimeter += distance(loop[i].point.position, loop[(i + 1) % loop.size()].point.position);
    segments += static_cast<double>(loop.size());
  }
  const double width = 2 * task.area / perimeter;
  return width < kNarrow * perimeter / segments;
}

/// A place in a strip may be wider than the rest: edges across it are longer than those of the
/// boundary.
bool hasLongEdges(const FrontInput& boundary, const Mesh& mesh) {
  constexpr double kLong = 2.2;
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
      if (edge > kLong * std::max(longest[from], longest[to])) return true;
    }
    return false;
  });
}

/// Chords of a narrow plane face may cross between their ends. No front could fill what they bound,
/// and to find that out takes long: so on a face that has failed before it is looked for first.
std::optional<FaceAttempt> refuseCrossed(const FaceTask& task) {
  const bool hasFailed = task.mostCandidates < std::numeric_limits<std::size_t>::max();
  if (!hasFailed || !task.surface.isPlane()) return std::nullopt;
  const BoundaryPicture picture(task.surface, task.boundary.input);
  if (crossingsOf(task.boundary.input, picture, 1).empty()) return std::nullopt;
  FaceAttempt attempt;
  attempt.fault = "segments of the boundary cross";
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
  if (task.mayLean) return fillLeaning(task);
  if (std::optional<FaceAttempt> refused = refuseCrossed(task)) return *std::move(refused);
  FaceAttempt filled = fillWithRules(task);
  const bool hasNoRoom = isNarrow(task);
  const bool mayBeBetter = hasNoRoom || (filled.fault.empty() && !isNearArea(task, filled));
  if (!mayBeBetter) return filled;
  FaceAttempt bare = fillWithoutVertices(task);
  if (!bare.fault.empty()) return filled;
  if (hasNoRoom && hasLongEdges(task.boundary.input, bare.result.mesh)) return filled;
  const bool isBetter =
      !filled.fault.empty() || (hasNoRoom ? worstDistortion(bare) < worstDistortion(filled)
                                          : areaError(task, bare) < areaError(task, filled));
  if (!isBetter) return filled;
  bare.steps = std::move(filled.steps);
  bare.effort += filled.effort;
  return bare;
}

}  // namespace af2::geometry
