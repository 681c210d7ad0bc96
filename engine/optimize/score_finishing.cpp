#include "engine/optimize/score_finishing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/base/eight_directions.h"
#include "engine/base/error.h"
#include "engine/base/work_watch.h"
#include "engine/mesh/mesh_check.h"
#include "engine/mesh/mesh_topology.h"
#include "engine/optimize/act_recorder.h"
#include "engine/optimize/element_badness.h"
#include "engine/step/neighborhood.h"

namespace af2 {
namespace {

/// Differences below this are rounding: ideal elements must not move about because of them.
constexpr double kNegligible = 1e-9;

/// The steps of the search for a better place of a vertex, as fractions of its shortest edge. Each
/// step is tried in each direction once, so a visit evaluates at most 40 places.
constexpr std::array kSteps{0.25, 0.125, 0.0625, 0.03125, 0.015625};

/// kEightDirections, those along the axes first: the first that is better is taken.
constexpr std::array<Point2, 8> kDirections{{{1, 0},
                                             {0, 1},
                                             {-1, 0},
                                             {0, -1},
                                             {kDiagonal, kDiagonal},
                                             {-kDiagonal, kDiagonal},
                                             {-kDiagonal, -kDiagonal},
                                             {kDiagonal, -kDiagonal}}};

bool isPlainlyLess(double a, double b) {
  if (!std::isfinite(b)) return std::isfinite(a);
  return a < b - kNegligible * (1 + std::abs(b));
}

/// Worst and sum of the badnesses of a few elements.
struct Total {
  double worst = -INFINITY, sum = 0;

  void add(double badness) {
    worst = std::max(worst, badness);
    sum += badness;
  }
  bool isBetterThan(const Total& other) const {
    if (!std::isfinite(worst) || worst > other.worst) return false;
    return isPlainlyLess(worst, other.worst) || isPlainlyLess(sum, other.sum);
  }
};

class ScoreFinisher {
 public:
  ScoreFinisher(Mesh& mesh, const MeshBoundary& boundary, const FinishTask& task,
                FinishObserver* observer)
      : mesh_(mesh),
        topology_(mesh, boundary),
        charts_(task.charts),
        badness_(mesh, task.rules, task.charts, task.size),
        isAwake_(mesh.vertices.size(), 1) {
    for (const Element& element : mesh.elements) of_.push_back(badness_.of(element));
    if (observer)
      recorder_.emplace(*observer, mesh, [this](const Element& e) { return badness_.of(e); });
  }

  std::size_t swapSides(const WorkWatch& watch) {
    std::size_t swaps = 0;
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
      if (watch.mustStopAt(e)) break;
      for (std::size_t i = 0; i < 3; ++i) {
        const Corner side(e, i);
        // Each side is visited from one of its two elements only.
        if (topology_.across(side).code > side.code) swaps += trySwap(side);
      }
    }
    for (const VertexId v : topology_.takeChanged()) isAwake_[v.value] = 1;
    return swaps;
  }

  /// One sweep over all inner vertices in order. A vertex sleeps while its star does not change.
  std::size_t moveVertices(const WorkWatch& watch) {
    std::size_t moves = 0;
    for (std::size_t v = topology_.fixedCount(); v < mesh_.vertices.size(); ++v) {
      if (watch.mustStopAt(v)) break;
      if (!std::exchange(isAwake_[v], 0)) continue;
      if (!tryMove(VertexId(v))) continue;
      ++moves;
      for (const std::size_t e : star_)
        for (const VertexId w : mesh_.elements[e].vertices()) isAwake_[w.value] = 1;
    }
    return moves;
  }

 private:
  bool trySwap(Corner side) {
    const Corner other = topology_.across(side);
    if (topology_.sizeOf(side) != 3 || topology_.sizeOf(other) != 3) return false;
    const std::size_t s = side.element(), t = other.element();
    const double worst = std::max(of_[s], of_[t]);
    const VertexId a = topology_.vertexAt(side), b = topology_.vertexAt(topology_.next(side));
    const VertexId c = topology_.vertexAt(topology_.previous(side));
    const VertexId d = topology_.vertexAt(topology_.previous(other));
    if (topology_.valence(a) <= fewest(a) || topology_.valence(b) <= fewest(b)) return false;
    if (topology_.areJoined(c, d)) return false;
    const std::array made{badness_.bestRotation({{a, d, c, VertexId()}}),
                          badness_.bestRotation({{d, b, c, VertexId()}})};
    const std::array badness{badness_.of(made[0]), badness_.of(made[1])};
    if (!isPlainlyLess(std::max(badness[0], badness[1]), worst)) return false;
    if (recorder_) recorder_->begin(std::array{s, t});
    const std::vector<std::size_t> places = topology_.replace({s, t}, made);
    if (recorder_) recorder_->end(FinishAct::Kind::SwapForQuality, places);
    for (std::size_t k = 0; k < places.size(); ++k) of_[places[k]] = badness[k];
    return true;
  }

  int fewest(VertexId v) const { return topology_.isFixed(v) ? 1 : 3; }

  bool tryMove(VertexId v) {
    if (!collectStar(v)) return false;
    if (recorder_) recorder_->begin(star_, v);
    Total before;
    for (const std::size_t e : star_) before.add(of_[e]);
    // Most places fail at the element that is worst now, so it is evaluated first.
    std::ranges::stable_sort(star_, [&](std::size_t e, std::size_t f) { return of_[e] > of_[f]; });
    try {
      return search(v, before);
    } catch (const GeometryError&) {
      return false;  // there is no chart at this vertex: it does not move
    }
  }

  /// Collects the elements around an inner vertex; returns false if some lie beyond the rim.
  bool collectStar(VertexId v) {
    star_.clear();
    shortest_ = INFINITY;
    const Corner first = topology_.cornerOf(v);
    Corner c = first;
    while (!c.isNone()) {
      star_.push_back(c.element());
      neighbor_ = topology_.vertexAt(topology_.next(c));
      shortest_ = std::min(shortest_, distance(mesh_.vertices[v.value].position,
                                               mesh_.vertices[neighbor_.value].position));
      c = topology_.aroundVertex(c);
      if (c == first) return shortest_ > 0;
    }
    return false;
  }

  /// A pattern search in the chart around the vertex, whose unit is the shortest edge there.
  bool search(VertexId v, Total best) {
    SurfacePoint& here = mesh_.vertices[v.value];
    const StepChart chart(
        charts_.makeLocalTransformIn(slot_, here, mesh_.vertices[neighbor_.value], shortest_),
        shortest_);
    SurfacePoint bestPoint = here;
    Point2 bestPlace;
    bool isMoved = false;
    for (const double step : kSteps) {
      for (const Point2& direction : kDirections) {
        const Point2 place = bestPlace + step * direction;
        const std::optional<SurfacePoint> lifted = chart.lift(place);
        if (!lifted) continue;
        put(v, *lifted);
        const Total total = totalAround(best.worst);
        if (!total.isBetterThan(best)) continue;
        best = total;
        bestPlace = place;
        bestPoint = *lifted;
        isMoved = true;
      }
    }
    put(v, bestPoint);
    if (!isMoved) return false;
    for (const std::size_t e : star_) of_[e] = badness_.of(mesh_.elements[e]);
    if (recorder_) recorder_->end(FinishAct::Kind::Move);
    return true;
  }

  void put(VertexId v, const SurfacePoint& point) {
    mesh_.vertices[v.value] = point;
    badness_.forget(v);
  }

  /// Infinite as soon as one element is worse than `limit` or has no value.
  Total totalAround(double limit) {
    Total total;
    for (const std::size_t e : star_) {
      const double badness = badness_.of(mesh_.elements[e]);
      total.add(badness > limit ? INFINITY : badness);
      if (!std::isfinite(total.worst)) break;
    }
    return total;
  }

  Mesh& mesh_;
  MeshTopology topology_;
  const AF2LocalTransformMaker& charts_;
  ElementBadness badness_;
  std::vector<double> of_;  ///< badness by element
  std::vector<std::uint8_t> isAwake_;
  std::vector<std::size_t> star_;  ///< elements around the vertex that is being moved
  VertexId neighbor_;              ///< some neighbour of that vertex
  double shortest_ = 0;            ///< length of the shortest edge there
  ChartSlot slot_;
  std::optional<ActRecorder> recorder_;
};

OptimizeReport improve(Mesh& mesh, const MeshBoundary& boundary, const FinishTask& task,
                       const OptimizeOptions& options) {
  OptimizeReport report;
  const WorkWatch watch(options.stop, options.goesOn);
  ScoreFinisher finisher(mesh, boundary, task, options.observer);
  for (int round = 0; round < options.rounds && !watch.mustStop(); ++round) {
    const std::size_t swaps = finisher.swapSides(watch);
    std::size_t moves = 0;
    for (int sweep = 0; sweep < options.smoothingSweeps && !watch.mustStop(); ++sweep)
      moves += finisher.moveVertices(watch);
    report.swaps += swaps;
    report.moves += moves;
    if (swaps + moves == 0) break;
  }
  report.swaps += finisher.swapSides(watch);
  return report;
}

}  // namespace

OptimizeReport finishByScore(Mesh& mesh, const MeshBoundary& boundary, const FinishTask& task,
                             const OptimizeOptions& options) {
  std::optional<Mesh> before;
  if (options.keepOriginal) before = mesh;
  if (options.observer) options.observer->finishBegun(mesh);
  OptimizeReport report = improve(mesh, boundary, task, options);
  report.isSound = checkMesh(mesh, boundary).empty();
  if (options.observer) options.observer->finishEnded(mesh, report.isSound);
  if (report.isSound || !before) return report;
  mesh = std::move(*before);
  return {};
}

}  // namespace af2
