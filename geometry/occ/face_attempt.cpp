#include "geometry/occ/face_attempt.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/error.h"
#include "engine/mesh_check.h"
#include "geometry/close_front.h"
#include "geometry/occ/face_trouble.h"

namespace af2::geometry {

namespace {

std::string toText(const Point3& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", p.x, p.y, p.z);
  return text;
}

/// Where and why the front got stuck: its first edge, and what kept the most promising rule away.
std::string stuckReason(const MeshingResult& result, const AF2Algorithm& algorithm) {
  std::string text =
      "the front got stuck with " + std::to_string(result.stuck.size()) + " edges left";
  if (result.stuck.empty()) return text;
  const StuckEdge& edge = result.stuck.front();
  text += ", the first from " + toText(result.mesh.vertices[edge.from.value].position) + " to " +
          toText(result.mesh.vertices[edge.to.value].position);
  const RuleRefusal* farthest = nullptr;
  for (const RuleRefusal& refusal : edge.refusals)
    if (!farthest || refusal.reason > farthest->reason) farthest = &refusal;
  if (farthest)
    text += "; rule '" + algorithm.rules().rules()[farthest->rule].name() +
            "': " + toString(farthest->reason);
  return text;
}

/// Stops a run that no longer fills a region but grows without end, because the boundary does not
/// enclose one; or that is stuck almost everywhere, though still trying. Goes by what has been
/// done, never by the clock.
class RunawayGuard {
 public:
  RunawayGuard(std::size_t limit, bool mayStall, const std::stop_token& outer)
      : limit_(limit), mayStall_(mayStall), forward_(outer, Forward{&source_}) {}

  std::stop_token token() const { return source_.get_token(); }
  void see(const Progress& progress) {
    ranAway_ = progress.elements > limit_;
    stalls_ = progress.elements < elements_ + kLeastGain ? stalls_ + 1 : 0;
    elements_ = progress.elements;
    if (ranAway_ || isStalled()) source_.request_stop();
  }
  bool ranAway() const { return ranAway_; }
  /// Thousands of steps brought next to nothing, and there is another way to try.
  bool isStalled() const { return mayStall_ && stalls_ >= kMostStalls; }

 private:
  struct Forward {
    std::stop_source* source;
    void operator()() const { source->request_stop(); }
  };
  static constexpr std::size_t kLeastGain = 64;  // elements from one report to the next
  static constexpr int kMostStalls = 2;

  std::size_t limit_, elements_ = 0;
  int stalls_ = 0;
  bool mayStall_, ranAway_ = false;
  std::stop_source source_;
  std::stop_callback<Forward> forward_;
};

/// Several times what the sizes along the boundary let expect. Only a size function may want much
/// smaller elements inside.
std::size_t elementLimit(const FaceTask& task) {
  constexpr double kUnitTriangle = 0.433;  // area of the one with edges of length 1
  constexpr double kMargin = 4, kFunctionMargin = 1e5;
  std::size_t corners = 0;
  double density = 0;
  for (const auto& loop : task.boundary.input.loops) {
    corners += loop.size();
    for (const BoundaryCorner& corner : loop) {
      const double size = task.size.sizeAt(corner.point);
      density += 1 / (size * size);
    }
  }
  const double byBoundary =
      task.area * density /
      (kUnitTriangle * static_cast<double>(std::max<std::size_t>(corners, 1)));
  const double expected = std::max(task.expectedElements, byBoundary);
  const double margin = task.mayBeFineInside ? kFunctionMargin : kMargin;
  return static_cast<std::size_t>(std::min(margin * expected, 1e9)) + 12 * corners + 2000;
}

/// Points of a face for the cuts between its pieces.
class FacePoints final : public SurfaceEvaluator {
 public:
  explicit FacePoints(const FaceSurface& surface) : surface_(surface) {}
  SurfacePoint at(double u, double v) const override {
    return surface_.pointAt(surface_.inParameters().pointAt(u, v).position, u, v);
  }

 private:
  const FaceSurface& surface_;
};

/// Runs the engine with a guard and reports what came of it.
template <class Run>
FaceAttempt guarded(const FaceTask& task, bool mayStall, Run&& run) {
  RunawayGuard guard(elementLimit(task), mayStall, task.options.stop);
  MeshingOptions options;
  options.stop = guard.token();
  if (task.options.observer) options.observer = task.options.observer(task.face);
  options.progress = [&](const Progress& progress) {
    guard.see(progress);
    if (task.progress) task.progress(progress);
  };
  FaceAttempt attempt = run(options);
  if (guard.ranAway())
    attempt.fault =
        "far more elements than the area has room for: the boundary does not enclose a region";
  else if (guard.isStalled())
    attempt.fault = "the front got stuck almost everywhere";
  else if (attempt.result.outcome == Outcome::Stuck)
    attempt.fault = stuckReason(attempt.result, task.algorithm);
  return attempt;
}

FaceAttempt attempt(const FaceTask& task, std::unique_ptr<AF2LocalTransformMaker> charts) {
  return guarded(task, false, [&](const MeshingOptions& options) {
    FaceAttempt attempt;
    attempt.charts = std::move(charts);
    attempt.result =
        task.algorithm.execute(*attempt.charts, task.boundary.input, task.size, options);
    if (attempt.result.outcome == Outcome::Complete)
      attempt.fault = faultOf(attempt.result.mesh, af2::boundaryOf(task.boundary.input));
    return attempt;
  });
}

/// Charts in the parameters.
bool hasSecondWay(const FaceTask& task) {
  return !task.surface.isPlane() && task.boundary.closedInParameters;
}

/// With the published charts, in pieces if the face is large.
FaceAttempt attemptInPieces(const FaceTask& task) {
  return guarded(task, hasSecondWay(task), [&](const MeshingOptions& options) {
    const FacePoints points(task.surface);
    const bool canCut = task.boundary.closedInParameters;
    RegionMesh mesh = meshRegion(task.algorithm,
                                 {task.boundary.input,
                                  task.makeTools,
                                  canCut ? &points : nullptr,
                                  {},
                                  task.options.optimize},
                                 options);
    FaceAttempt attempt;
    attempt.charts = task.surface.makeCharts({});
    attempt.result = std::move(mesh.result);
    attempt.fault = std::move(mesh.fault);
    attempt.isOptimized = task.options.optimize;
    attempt.optimizeShare = mesh.seconds > 0 ? mesh.optimizeSeconds / mesh.seconds : 0;
    return attempt;
  });
}

/// The plane across the mean normal of the vertices that are left on the front.
ProjectionFrame planeOfFront(const MeshingResult& result) {
  Point3 normal;
  for (const StuckEdge& edge : result.stuck)
    normal = normal + result.mesh.vertices[edge.from.value].normal;
  normal = unit(normal);
  ProjectionFrame frame;
  frame.origin = result.mesh.vertices[result.stuck.front().from.value].position;
  const PlaneAxes axes(frame.origin, normal);
  frame.xAxis = axes.xAxis();
  frame.yAxis = axes.yAxis();
  frame.normal = normal;
  return frame;
}

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
bool close(const FaceTask& task, FaceAttempt& attempt, bool inParameters) {
  if (attempt.result.outcome != Outcome::Stuck || attempt.result.stuck.empty()) return false;
  MeshingResult closed = attempt.result;
  const auto& vertices = attempt.result.mesh.vertices;
  const auto rule = static_cast<std::uint16_t>(task.algorithm.rules().rules().size());
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
    const ProjectionFrame plane = planeOfFront(closed);
    done = closeFront(
        closed, [&](VertexId v) { return plane.project(vertices[v.value]).position; }, rule);
  }
  if (!done || !faultOf(closed.mesh, af2::boundaryOf(task.boundary.input)).empty()) return false;
  attempt.closingElements = closed.mesh.elements.size() - attempt.result.mesh.elements.size();
  attempt.result = std::move(closed);
  attempt.fault.clear();
  return true;
}

/// Whether the wanted edges turn so far that a plane across the mean normal would fold within the
/// reach of the rules, while the surface can be unrolled without any distortion.
bool isBetterUnrolled(const FaceTask& task) {
  constexpr double kMostTurn = 0.45;  // radians
  if (!task.surface.isDeveloped() || !hasSecondWay(task)) return false;
  for (const auto& loop : task.boundary.input.loops)
    for (const BoundaryCorner& corner : loop)
      if (task.size.sizeAt(corner.point) >
          kMostTurn * task.surface.radiiAt(corner.point, 0).smallest)
        return true;
  return false;
}

FaceAttempt attemptInParameters(const FaceTask& task) {
  return attempt(task, std::make_unique<MetricChartMaker>(task.surface.inParameters()));
}

FaceAttempt fillWithRules(const FaceTask& task) {
  if (isBetterUnrolled(task)) {
    FaceAttempt unrolled = attemptInParameters(task);
    if (unrolled.fault.empty()) return unrolled;
  }
  FaceAttempt first = attemptInPieces(task);
  if (first.fault.empty()) return first;
  std::vector<std::string> steps{(task.surface.isPlane() ? "plane: " : "mean normal planes: ") +
                                 first.fault};
  const bool hasSecond = hasSecondWay(task);
  FaceAttempt second;
  if (hasSecond) {
    second = attemptInParameters(task);
    second.steps = steps;
    if (second.fault.empty()) return second;
    steps.push_back("charts in parameters: " + second.fault);
  }
  first.steps = second.steps = steps;
  if (close(task, first, false)) return first;
  if (hasSecond && close(task, second, !hasTwoSheets(task.boundary.input))) return second;
  if (hasSecond) first.fault += "; in parameters: " + second.fault;
  first.failures.push_back(first.result);
  first.failures.push_back(std::move(second.result));
  return first;
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
  attempt.charts = task.surface.makeCharts({});
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
  close(task, attempt, true);
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
