#include "geometry/occ/chart_attempt.h"

#include <algorithm>

#include "engine/error.h"
#include "engine/mesh_check.h"
#include "geometry/laid_out.h"
#include "geometry/stuck_front.h"

namespace af2::geometry {

namespace {

/// Stops a run that no longer fills a region but grows without end, because the boundary does not
/// enclose one; or whose front is so crammed that no end is in sight. Goes by what all pieces of a
/// face have done, never by the clock or by which of them came first.
class RunawayGuard {
 public:
  RunawayGuard(std::size_t limit, const std::stop_token& outer)
      : limit_(limit), forward_(outer, Forward{&source_}) {}

  std::stop_token token() const { return source_.get_token(); }
  void see(const Progress& progress) {
    ranAway_ = ranAway_ || progress.elements > limit_;
    isCrammed_ = isCrammed_ || progress.candidates > kCandidatesPerElement * limit_;
    if (ranAway_ || isCrammed_) source_.request_stop();
  }
  bool ranAway() const { return ranAway_; }
  bool isCrammed() const { return isCrammed_; }

 private:
  struct Forward {
    std::stop_source* source;
    void operator()() const { source->request_stop(); }
  };
  /// Ten times what the most elements that are allowed would need.
  static constexpr std::size_t kCandidatesPerElement = 30;

  std::size_t limit_;
  bool ranAway_ = false, isCrammed_ = false;
  std::stop_source source_;
  std::stop_callback<Forward> forward_;
};

/// For a face whose area is not known: that of a sphere as large as it.
double mostArea(const FaceTask& task) {
  const Point3& origin = task.boundary.input.loops[0][0].point.position;
  double extent = task.surface.extent();
  for (const auto& loop : task.boundary.input.loops)
    for (const BoundaryCorner& corner : loop)
      extent = std::max(extent, distance(corner.point.position, origin));
  return 3.15 * extent * extent;
}

/// Several times what the sizes along the boundary let expect. Only a size function may want much
/// smaller elements inside.
std::size_t elementLimit(const FaceTask& task) {
  constexpr double kUnitTriangle = 0.433;  // area of the one with edges of length 1
  constexpr double kMargin = 4, kFunctionMargin = 1e5;
  std::size_t corners = 0;
  double density = 0;
  const double area = task.area > 0 ? task.area : mostArea(task);
  for (const auto& loop : task.boundary.input.loops) {
    corners += loop.size();
    for (const BoundaryCorner& corner : loop) {
      const double size = task.size.sizeAt(corner.point);
      density += 1 / (size * size);
    }
  }
  const double byBoundary =
      area * density / (kUnitTriangle * static_cast<double>(std::max<std::size_t>(corners, 1)));
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

void take(RegionMesh& mesh, const FaceTask& task, FaceAttempt& attempt) {
  attempt.result = std::move(mesh.result);
  attempt.fault = std::move(mesh.fault);
  attempt.isOptimized = task.options.optimize;
  attempt.optimizeShare = mesh.seconds > 0 ? mesh.optimizeSeconds / mesh.seconds : 0;
}

/// Seen anew from each base edge, in pieces if the face is large.
FaceAttempt fillInPieces(const FaceTask& task, ChartKind kind, const MeshingOptions& options) {
  const FacePoints points(task.surface);
  RegionMesh mesh = meshRegion(task.algorithm,
                               {task.boundary.input,
                                [&] { return task.makeTools(kind); },
                                task.boundary.canBeCut ? &points : nullptr,
                                {},
                                task.options.optimize},
                               options);
  FaceAttempt attempt;
  attempt.charts = task.surface.makeCharts(kind);
  take(mesh, task, attempt);
  return attempt;
}

/// As one piece, not optimised: these charts know a vertex of a seam on one of its sheets only.
FaceAttempt fillInParameters(const FaceTask& task, ChartKind kind, const MeshingOptions& options) {
  FaceAttempt attempt;
  attempt.charts = task.surface.makeCharts(kind);
  attempt.result = task.algorithm.execute(*attempt.charts, task.boundary.input, task.size, options);
  if (attempt.result.outcome == Outcome::Complete)
    attempt.fault = faultOf(attempt.result.mesh, boundaryOf(task.boundary.input));
  return attempt;
}

/// The whole face laid out in one plane.
FaceAttempt fillLaidOut(const FaceTask& task, ChartKind kind, const MeshingOptions& options) {
  const std::unique_ptr<PlaneMap> map = task.surface.makePlaneMap(kind);
  const LaidOutFront front = layOut(task.boundary.input, *map);
  const PlanePoints points;
  FaceAttempt attempt;
  attempt.charts = task.surface.makeCharts(ChartKind::MeanNormal);
  try {
    RegionMesh mesh = meshRegion(
        task.algorithm,
        {front.input, [&] { return task.makeTools(kind); }, &points, {}, task.options.optimize},
        options);
    take(mesh, task, attempt);
  } catch (const InputError& error) {
    attempt.fault = error.what();  // the curves in the parameters are not what they should be
    return attempt;
  }
  lift(attempt.result, front, task.boundary.input, *map);
  if (attempt.result.outcome == Outcome::Complete && attempt.fault.empty())
    attempt.fault = faultOfLifted(attempt.result.mesh, front, task.boundary.input);
  return attempt;
}

FaceAttempt fill(const FaceTask& task, ChartKind kind, const MeshingOptions& options) {
  switch (kind) {
    case ChartKind::Developed:
    case ChartKind::Conformal:
      return fillLaidOut(task, kind, options);
    case ChartKind::Parametric:
    case ChartKind::Affine:
      return fillInParameters(task, kind, options);
    default:
      return fillInPieces(task, kind, options);
  }
}

}  // namespace

FaceAttempt attemptWith(const FaceTask& task, ChartKind kind, int patience) {
  RunawayGuard guard(elementLimit(task), task.options.stop);
  MeshingOptions options;
  options.patience = patience;
  options.stop = guard.token();
  if (task.options.observer) options.observer = task.options.observer(task.face);
  options.progress = [&](const Progress& progress) {
    guard.see(progress);
    if (task.progress) task.progress(progress);
  };
  FaceAttempt attempt = fill(task, kind, options);
  attempt.chart = kind;
  if (guard.ranAway())
    attempt.fault =
        "far more elements than the area has room for: the boundary does not enclose a region";
  else if (guard.isCrammed())
    attempt.fault = "the front is so crammed that no end is in sight";
  else if (attempt.result.outcome == Outcome::Stuck)
    attempt.fault = stuckReason(attempt.result, task.algorithm);
  return attempt;
}

}  // namespace af2::geometry
