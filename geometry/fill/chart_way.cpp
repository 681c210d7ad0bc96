#include "geometry/fill/chart_way.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "engine/base/constants.h"
#include "engine/base/elementary.h"
#include "engine/base/error.h"
#include "engine/mesh/mesh_check.h"
#include "geometry/charts/laid_out.h"
#include "geometry/check/model_check.h"
#include "geometry/fill/diagnose_face.h"
#include "geometry/fill/fill_limits.h"
#include "geometry/fill/stuck_front.h"
#include "geometry/fill/without_normals.h"

namespace af2::geometry {

namespace {

/// Units of the area of a face, in which that of its elements is measured.
constexpr double kAreaUnits = 1 << 20;

/// Of all that the face gets to that of the face.
///
/// made  area of the elements that the front has made
double ratioOfAreas(const FaceTask& task, double made) {
  return (made + task.areaBeside) / (task.area + task.areaBeside);
}

/// Stops a run that no longer fills a region but grows without end, because the boundary does not
/// enclose one; whose elements overlap; or whose front is so crammed that no end is in sight.
/// Depends on what all pieces of a face have done, never on the clock or on which of them came
/// first.
class RunawayGuard {
 public:
  /// margin  how many times more elements than are expected the limit allows
  RunawayGuard(const FaceTask& task, std::size_t limit, double margin)
      : task_(task),
        limit_(limit),
        maxCandidates_(std::min(task.limits.maxCandidates, candidatesFor(limit, margin))),
        forward_(task.options.stop, Forward{&source_}) {}

  std::stop_token token() const { return source_.get_token(); }
  void see(const Progress& progress) {
    ranAway_ = ranAway_ || progress.elements > limit_;
    isCrammed_ = isCrammed_ || progress.candidates > maxCandidates_;
    overlaps_ = overlaps_ || haveTooMuchArea(progress);
    if (ranAway_ || isCrammed_ || overlaps_) source_.request_stop();
  }
  bool ranAway() const { return ranAway_; }
  bool isCrammed() const { return isCrammed_; }
  bool overlaps() const { return overlaps_; }

 private:
  struct Forward {
    std::stop_source* source;
    void operator()() const { source->request_stop(); }
  };
  /// As the check of the complete face will find.
  bool haveTooMuchArea(const Progress& progress) const {
    if (progress.area == 0) return false;
    const double ratio =
        ratioOfAreas(task_, static_cast<double>(progress.area) / kAreaUnits * task_.area);
    return ratio > 1 && isWrongArea(ratio, progress.elements);
  }
  static std::size_t candidatesFor(std::size_t limit, double margin) {
    return static_cast<std::size_t>(margin * kCandidatesPerElement * static_cast<double>(limit));
  }

  const FaceTask& task_;
  std::size_t limit_, maxCandidates_;
  bool ranAway_ = false, isCrammed_ = false, overlaps_ = false;
  std::stop_source source_;
  std::stop_callback<Forward> forward_;
};

/// Elements per area that the sizes along the boundary let expect: by the mean of their inverses
/// over its length, so that a few tiny segments hardly count.
double boundaryDensity(const FaceTask& task) {
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

/// The multiple of the expected elements above which a front counts as overlapping itself.
double marginOf(const FaceTask& task) {
  return task.knowsSizes ? kElementMarginOfKnownSizes : kElementMargin;
}

/// The number of elements expected from the sizes. If the area of a face is unknown, the sizes
/// along its boundary say nothing about its inside, because sizes grow from there.
double expectedElements(const FaceTask& task) {
  if (!(task.area > 0)) return task.expectedElements;
  return std::max(task.expectedElements, task.area * boundaryDensity(task));
}

/// The elements next to the segments, where sizes grow from the length of the segments.
double elementsBeside(const FrontInput& input) {
  double longest = 0, sum = 0;
  std::vector<double> lengths;
  for (const auto& loop : input.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      lengths.push_back(
          distance(loop[i].point.position, loop[(i + 1) % loop.size()].point.position));
      longest = std::max(longest, lengths.back());
    }
  for (const double length : lengths) sum += length > 0 ? 1 + logarithm(longest / length) : 1;
  return kElementsBesideSegment * (sum + static_cast<double>(input.isolated.size()));
}

/// Several times what is expected, and what sizes by position may want inside.
std::size_t elementLimit(const FaceTask& task) {
  const double expected = task.knowsSizes ? task.expectedElements : expectedElements(task);
  const double beside = elementsBeside(task.boundary.input) + kElementsAlways;
  const double limit = marginOf(task) * task.finer.most(expected) + beside;
  return static_cast<std::size_t>(limit < kMaxElements ? limit
                                                       : kMaxElements);  // also if it is no number
}

FillFault unsound(std::string details) {
  if (details.empty()) return {};
  return {FillFaultKind::Unsound, std::move(details)};
}

void take(RegionMesh& mesh, const FaceTask& task, FaceAttempt& attempt) {
  attempt.result = std::move(mesh.result);
  attempt.fault = unsound(std::move(mesh.fault));
  // A front that got stuck is left as it is: what closes it later is to be optimised, too.
  attempt.isOptimized = task.options.optimize && attempt.result.outcome == Outcome::Complete;
  attempt.optimizeShare = mesh.seconds > 0 ? mesh.optimizeSeconds / mesh.seconds : 0;
}

/// Uses a new chart for each base edge, and meshes a large face in pieces.
FaceAttempt inPieces(const FaceTask& task, ChartKind kind, const FrontOptions& options) {
  RegionMesh mesh = meshRegion(task.algorithm,
                               {task.boundary.input,
                                [&] { return task.makeTools(kind); },
                                task.boundary.canBeCut ? &task.surface : nullptr,
                                {},
                                task.options.optimize,
                                0,
                                task.options.quads,
                                task.options.crew},
                               options);
  FaceAttempt attempt;
  attempt.charts = task.surface.makeCharts(kind);
  take(mesh, task, attempt);
  return attempt;
}

/// For fronts whose elements nothing will mend.
FrontOptions withoutReflex(FrontOptions options) {
  options.acceptReflex = false;
  return options;
}

/// As one piece, not optimised: these charts know a vertex of a seam on one of its sheets only.
FaceAttempt inParameters(const FaceTask& task, ChartKind kind, const FrontOptions& options) {
  FaceAttempt attempt;
  attempt.charts = task.surface.makeCharts(kind);
  attempt.result = task.algorithm.execute(*attempt.charts, task.boundary.input, task.size,
                                          withoutReflex(options));
  if (attempt.result.outcome == Outcome::Complete)
    attempt.fault = unsound(faultOf(attempt.result.mesh, boundaryOf(task.boundary.input)));
  attempt.chartsKnowOneSheet = true;
  return attempt;
}

/// The whole face laid out in one plane.
FaceAttempt laidOut(const FaceTask& task, ChartKind kind, const FrontOptions& options) {
  const std::unique_ptr<PlaneMap> map = task.surface.makePlaneMap(kind);
  const LaidOutFront front = layOut(task.boundary.input, *map);
  const PlanePoints points;
  FaceAttempt attempt;
  attempt.charts = task.surface.makeCharts(ChartKind::MeanNormal);
  try {
    RegionMesh mesh = meshRegion(task.algorithm,
                                 {front.input,
                                  [&] { return task.makeTools(kind); },
                                  &points,
                                  {},
                                  task.options.optimize,
                                  0,
                                  task.options.quads,
                                  task.options.crew},
                                 options);
    take(mesh, task, attempt);
  } catch (const InputError& error) {
    attempt.fault = {FillFaultKind::BadParameters, error.what()};
    return attempt;
  }
  lift(attempt.result, front, task.boundary.input, *map);
  if (attempt.result.outcome == Outcome::Complete && attempt.fault.isNone())
    attempt.fault = unsound(
        faultOfLifted(attempt.result.mesh, front, task.boundary.input, task.limits.ignoresNormals));
  return attempt;
}

/// The charts of the parameters with the metric of a surface that has no normals.
FaceAttempt inParametersWithoutNormals(const FaceTask& task, ChartKind,
                                       const FrontOptions& options) {
  const WithoutNormals surface(*task.surface.inParameters());
  const MetricChartMaker charts(surface, MetricOrder::First);
  const FrontInput input = withoutNormals(task.boundary.input);
  FaceAttempt attempt;
  attempt.result = task.algorithm.execute(charts, input, task.size, withoutReflex(options));
  if (attempt.result.outcome == Outcome::Complete)
    attempt.fault = unsound(faultOf(attempt.result.mesh, boundaryOf(input)));
  attempt.isOptimized = true;  // the optimiser knows folds by the normals
  return attempt;
}

/// The rules that made most elements of a front, with their shares.
std::string mostActiveRules(const FaceTask& task, const Mesh& mesh) {
  constexpr std::size_t kMaxNamed = 3;
  const auto& rules = task.algorithm.rules().rules();
  std::vector<std::pair<std::size_t, std::size_t>> made(rules.size());  // count, rule
  for (std::size_t rule = 0; rule < rules.size(); ++rule) made[rule].second = rule;
  for (const ElementOrigin& origin : mesh.origins) ++made[origin.rule].first;
  std::ranges::stable_sort(made, std::greater<>(), &std::pair<std::size_t, std::size_t>::first);
  std::string names;
  for (const auto& [count, rule] : std::span(made).first(std::min(kMaxNamed, made.size()))) {
    if (count == 0) break;
    const auto share =
        std::lround(100 * static_cast<double>(count) / static_cast<double>(mesh.elements.size()));
    names += (names.empty() ? ", most by '" : ", '") + rules[rule].name() + "' (" +
             std::to_string(share) + " %)";
  }
  return names;
}

/// How many elements a stopped front made, and how many the sizes let expect.
std::string elementsOfStoppedFront(const FaceTask& task, const Mesh& mesh) {
  const double expected = std::clamp(expectedElements(task), 1.0, kMaxElements);
  return std::to_string(mesh.elements.size()) + " elements were made where the sizes let expect " +
         std::to_string(std::lround(expected)) + mostActiveRules(task, mesh);
}

std::string areaOfStoppedFront(const FaceTask& task, const Mesh& mesh) {
  char ratio[32];
  std::snprintf(ratio, sizeof ratio, "%.2f", ratioOfAreas(task, areaOfElements(mesh)));
  return std::to_string(mesh.elements.size()) + " elements have " + ratio +
         " times the area of the face" + mostActiveRules(task, mesh);
}

/// 0 where elements cannot overlap, or where their area in the front is not that on the surface.
double areaUnitOf(const FaceTask& task, const ChartTraits& chart) {
  const bool isMeasured = chart.drawing != ChartDrawing::WholeFace && !task.surface.isPlane();
  return isMeasured && task.area > 0 ? task.area / kAreaUnits : 0;
}

/// Runs a front as long as that gets on.
///
/// stallLimit  FrontOptions::stallSteps
template <class Run>
FaceAttempt guarded(const FaceTask& task, const ChartTraits& chart, int stallLimit, Run&& run) {
  RunawayGuard guard(task, elementLimit(task), marginOf(task));
  FrontOptions options;
  options.stallSteps = stallLimit;
  options.stallCandidates = kStallCandidates;
  options.acceptReflex = !task.limits.refusesReflex;
  options.areaUnit = areaUnitOf(task, chart);
  options.stop = guard.token();
  if (task.options.observer) options.observer = task.options.observer();
  options.progress = [&](const Progress& progress) {
    guard.see(progress);
    if (task.progress) task.progress(progress);
  };
  FaceAttempt attempt = run(task, chart.kind, options);
  attempt.chart = chart.kind;
  attempt.isDrawnInParameters = chart.canCloseInParameters;
  attempt.searchCost = attempt.result.candidates;
  // What was refused says where to begin only if the front would have gone on in vain.
  if (attempt.result.outcome == Outcome::Cancelled && !guard.overlaps())
    attempt.result.stuck.clear();
  if (guard.overlaps())
    attempt.fault = {FillFaultKind::TooMuchArea, areaOfStoppedFront(task, attempt.result.mesh)};
  else if (guard.ranAway())
    attempt.fault = {FillFaultKind::TooManyElements,
                     elementsOfStoppedFront(task, attempt.result.mesh)};
  else if (guard.isCrammed())
    attempt.fault = {FillFaultKind::TooManyCandidates,
                     elementsOfStoppedFront(task, attempt.result.mesh)};
  else if (attempt.result.outcome == Outcome::Stuck)
    attempt.fault = {FillFaultKind::Stuck, stuckReason(attempt.result, task.algorithm)};
  return attempt;
}

const ChartTraits& traitsOf(ChartKind kind) {
  return *std::ranges::find(chartKinds(), kind, &ChartTraits::kind);
}

int lastStallLimit(const FillState& state) {
  const FaceTask& task = state.task;
  if (!task.limits.failedBefore && state.failed.empty()) return 0;
  int limit = kLastStallLimit;
  for (const AF2Rule& rule : task.algorithm.rules().rules())
    limit = std::max(limit, rule.definition().firstLevel);
  return limit;
}

}  // namespace

FaceAttempt attemptWith(const FaceTask& task, const ChartTraits& chart, int stallLimit) {
  switch (chart.drawing) {
    case ChartDrawing::InParameters:
      return guarded(task, chart, stallLimit, inParameters);
    case ChartDrawing::WholeFace:
      return guarded(task, chart, stallLimit, laidOut);
    case ChartDrawing::EachStep:
      break;
  }
  return guarded(task, chart, stallLimit, inPieces);
}

FaceAttempt fillThroughCharts(FillState& state) {
  for (const ChartTraits* chart : state.charts) {
    const bool isLast = chart == state.charts.back();
    const int stallLimit = isLast ? lastStallLimit(state) : kStallLimit;
    FaceAttempt attempt = attemptWith(state.task, *chart, stallLimit);
    if (attempt.fault.isNone()) return attempt;
    state.fail(std::string(chart->name) + " charts", std::move(attempt));
  }
  FaceAttempt none;
  none.fault.kind = FillFaultKind::NotFilled;
  return none;
}

FaceAttempt attemptIgnoringNormals(const FaceTask& task) {
  for (const ChartKind kind : {ChartKind::Developed, ChartKind::Conformal})
    if (task.surface.has(kind)) return attemptWith(task, traitsOf(kind), 0);
  return guarded(task, traitsOf(ChartKind::Affine), 0, inParametersWithoutNormals);
}

}  // namespace af2::geometry
