#include "geometry/fill/chart_attempt.h"

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "engine/mesh/mesh_check.h"
#include "geometry/charts/laid_out.h"
#include "geometry/fill/leaning_attempt.h"
#include "geometry/fill/stuck_front.h"

namespace af2::geometry {

namespace {

/// Stops a run that no longer fills a region but grows without end, because the boundary does not
/// enclose one; or whose front is so crammed that no end is in sight. Goes by what all pieces of a
/// face have done, never by the clock or by which of them came first.
class RunawayGuard {
 public:
  /// margin  how many times more elements than are expected the limit allows
  RunawayGuard(std::size_t limit, double margin, std::size_t mostCandidates,
               const std::stop_token& outer)
      : limit_(limit),
        mostCandidates_(std::min(mostCandidates, candidatesFor(limit, margin))),
        forward_(outer, Forward{&source_}) {}

  std::stop_token token() const { return source_.get_token(); }
  void see(const Progress& progress) {
    ranAway_ = ranAway_ || progress.elements > limit_;
    isCrammed_ = isCrammed_ || progress.candidates > mostCandidates_;
    if (ranAway_ || isCrammed_) source_.request_stop();
  }
  bool ranAway() const { return ranAway_; }
  bool isCrammed() const { return isCrammed_; }

 private:
  struct Forward {
    std::stop_source* source;
    void operator()() const { source->request_stop(); }
  };
  /// Some times what the most elements that are allowed would need, about three each.
  static std::size_t candidatesFor(std::size_t limit, double margin) {
    constexpr double kCandidatesPerElement = 7.5;
    return static_cast<std::size_t>(margin * kCandidatesPerElement * static_cast<double>(limit));
  }

  std::size_t limit_, mostCandidates_;
  bool ranAway_ = false, isCrammed_ = false;
  std::stop_source source_;
  std::stop_callback<Forward> forward_;
};

/// Elements per area that the sizes along the boundary let expect: by the mean of their inverses
/// over its length, so that a few tiny segments hardly count.
double boundaryDensity(const FaceTask& task) {
  constexpr double kUnitTriangle = 0.433;  // area of the one with edges of length 1
  double segments = 0, perimeter = 0;
  for (const auto& loop : task.boundary.input.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const double segment =
          distance(loop[i].point.position, loop[(i + 1) % loop.size()].point.position);
      const double size = task.size.sizeAt(loop[i].point);
      segments += segment / size;
      perimeter += segment;
    }
  }
  const double perSize = perimeter > 0 ? segments / perimeter : 0;
  return perSize * perSize / kUnitTriangle;
}

/// How many times more elements than expected mean that a front folds over.
double marginOf(const FaceTask& task) { return task.knowsSizes ? 2 : 4; }

/// How many elements the sizes let expect. Along the boundary of a face whose area is not known
/// these tell nothing of its inside: sizes grow from there.
double expectedElements(const FaceTask& task) {
  if (!(task.area > 0)) return task.expectedElements;
  return std::max(task.expectedElements, task.area * boundaryDensity(task));
}

/// Room beside the segments, in which elements grow from the length of these.
double elementsBeside(const FrontInput& input) {
  constexpr double kBeside = 12;
  double longest = 0, sum = 0;
  std::vector<double> lengths;
  for (const auto& loop : input.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      lengths.push_back(
          distance(loop[i].point.position, loop[(i + 1) % loop.size()].point.position));
      longest = std::max(longest, lengths.back());
    }
  for (const double length : lengths) sum += length > 0 ? 1 + std::log(longest / length) : 1;
  return kBeside * (sum + static_cast<double>(input.isolated.size()));
}

/// Several times what is expected. Only a size function may want much smaller elements inside.
std::size_t elementLimit(const FaceTask& task) {
  constexpr double kFunctionMargin = 1e5, kAlways = 2000, kMost = 1e9;
  const double expected = task.knowsSizes ? task.expectedElements : expectedElements(task);
  const double margin = task.mayBeFineInside ? kFunctionMargin : marginOf(task);
  const double beside = elementsBeside(task.boundary.input) + kAlways;
  const double limit = margin * expected + beside;
  return static_cast<std::size_t>(limit < kMost ? limit : kMost);  // also if it is no number
}

void take(RegionMesh& mesh, const FaceTask& task, FaceAttempt& attempt) {
  attempt.result = std::move(mesh.result);
  attempt.fault = std::move(mesh.fault);
  attempt.isOptimized = task.options.optimize;
  attempt.optimizeShare = mesh.seconds > 0 ? mesh.optimizeSeconds / mesh.seconds : 0;
}

/// Seen anew from each base edge, in pieces if the face is large.
FaceAttempt fillInPieces(const FaceTask& task, ChartKind kind, const MeshingOptions& options) {
  RegionMesh mesh = meshRegion(task.algorithm,
                               {task.boundary.input,
                                [&] { return task.makeTools(kind); },
                                task.boundary.canBeCut ? &task.surface : nullptr,
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
///
/// mayLean  elements may lean against the surface as far as they like
FaceAttempt fillLaidOut(const FaceTask& task, ChartKind kind, const MeshingOptions& options,
                        bool mayLean = false) {
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
    attempt.fault = faultOfLifted(attempt.result.mesh, front, task.boundary.input, mayLean);
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

/// Runs one way to fill a face as long as that gets on.
template <class Fill>
FaceAttempt guarded(const FaceTask& task, int patience, Fill&& fill) {
  RunawayGuard guard(elementLimit(task), marginOf(task), task.mostCandidates, task.options.stop);
  // Nearly twice what any front of the public models took on its way to a whole face (counted
  // once).
  constexpr std::size_t kMostInVain = 4'000'000;
  MeshingOptions options;
  options.patience = patience;
  options.mostInVain = kMostInVain;
  options.stop = guard.token();
  if (task.options.observer) options.observer = task.options.observer();
  options.progress = [&](const Progress& progress) {
    guard.see(progress);
    if (task.progress) task.progress(progress);
  };
  FaceAttempt attempt = fill(options);
  if (guard.ranAway())
    attempt.fault =
        "far more elements than the area has room for: the boundary does not enclose a region";
  else if (guard.isCrammed())
    attempt.fault = "the front is so crammed that no end is in sight";
  else if (attempt.result.outcome == Outcome::Stuck)
    attempt.fault = stuckReason(attempt.result, task.algorithm);
  return attempt;
}

}  // namespace

FaceAttempt attemptWith(const FaceTask& task, ChartKind kind, int patience) {
  FaceAttempt attempt = guarded(
      task, patience, [&](const MeshingOptions& options) { return fill(task, kind, options); });
  attempt.chart = kind;
  return attempt;
}

FaceAttempt attemptLeaning(const FaceTask& task) {
  const int patience = MeshingOptions{}.patience;
  for (const ChartKind kind : {ChartKind::Developed, ChartKind::Conformal}) {
    if (!task.surface.has(kind)) continue;
    FaceAttempt attempt = guarded(task, patience, [&](const MeshingOptions& options) {
      return fillLaidOut(task, kind, options, true);
    });
    attempt.chart = kind;
    return attempt;
  }
  const WithoutNormals surface(*task.surface.inParameters());
  const MetricChartMaker charts(surface, MetricOrder::First);
  const FrontInput input = withoutNormals(task.boundary.input);
  FaceAttempt attempt = guarded(task, patience, [&](const MeshingOptions& options) {
    FaceAttempt filled;
    filled.result = task.algorithm.execute(charts, input, task.size, options);
    if (filled.result.outcome == Outcome::Complete)
      filled.fault = faultOf(filled.result.mesh, boundaryOf(input));
    return filled;
  });
  attempt.chart = ChartKind::Affine;
  attempt.isOptimized = true;  // the optimiser knows folds by the normals
  return attempt;
}

}  // namespace af2::geometry
