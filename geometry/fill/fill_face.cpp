#include "geometry/fill/fill_face.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "geometry/fill/fill_way.h"

namespace af2::geometry {

namespace {

/// Whether the surface and the boundary have charts of a kind.
bool isPossible(const FaceTask& task, const ChartTraits& chart) {
  const bool hasParameters = task.surface.inParameters() && task.boundary.closedInParameters;
  return (!chart.needsParameters || hasParameters) && task.surface.has(chart.kind);
}

/// Those that suit the face, but first that which was asked for.
std::vector<const ChartTraits*> chartsFor(const FaceTask& task) {
  std::vector<ChartKind> possible;
  for (const ChartTraits& chart : chartKinds())
    if (isPossible(task, chart)) possible.push_back(chart.kind);
  std::vector<const ChartTraits*> charts;
  for (const ChartTraits& chart : chartKinds()) {
    if (!isPossible(task, chart)) continue;
    if (chart.kind == task.options.chart)
      charts.insert(charts.begin(), &chart);
    else if (chart.suits(possible))
      charts.push_back(&chart);
  }
  if (task.options.strictRules && !charts.empty()) charts.erase(charts.begin() + 1, charts.end());
  return charts;
}

/// Takes the ways one after the other and keeps what comes of them.
class Filling {
 public:
  explicit Filling(const FaceTask& task) : state_{task, chartsFor(task)} {}

  FilledFace fill() {
    for (const FillWay& way : fillWays()) {
      if (way.ignoresNormals != state_.task.limits.ignoresNormals) continue;
      if (way.needsNoRule && state_.task.options.strictRules) continue;
      if (!way.applies(state_)) continue;
      FaceAttempt attempt = way.fill(state_);
      if (attempt.fault.isNone())
        take(way, std::move(attempt));
      else if (way.isCondition && attempt.fault.kind != FillFaultKind::NotFilled)
        return impossible(std::move(attempt));
      else
        state_.fail(way.name, std::move(attempt));
    }
    return finished();
  }

 private:
  void take(const FillWay& way, FaceAttempt attempt) {
    state_.searchCost += attempt.searchCost;
    if (!way.isBetter || way.isBetter(state_, attempt)) state_.best = std::move(attempt);
  }

  static FilledFace impossible(FaceAttempt attempt) {
    FilledFace filled;
    filled.attempt = std::move(attempt);
    return filled;
  }

  FilledFace finished() {
    FilledFace filled;
    filled.searchCost = state_.searchCost;
    if (state_.best) {
      filled.attempt = std::move(*state_.best);
    } else {
      filled.attempt.fault = faultOfAll();
      for (FaceAttempt& attempt : state_.failed)
        filled.failures.push_back(std::move(attempt.result));
    }
    filled.history = std::move(state_.history);
    return filled;
  }

  FillFault faultOfAll() const {
    if (state_.history.empty()) return {FillFaultKind::NotFilled, {}};
    std::string texts;
    for (const FaceStep& step : state_.history) texts += (texts.empty() ? "" : "; ") + textOf(step);
    return {FillFaultKind::EveryWayFailed, std::move(texts)};
  }

  FillState state_;
};

}  // namespace

void FillState::fail(std::string name, FaceAttempt attempt) {
  searchCost += attempt.searchCost;
  if (attempt.fault.kind == FillFaultKind::NotFilled) return;
  history.push_back(failedWay(std::move(name), attempt.fault));
  failed.push_back(std::move(attempt));
}

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

bool hasOneSheet(const FaceTask& task) {
  return task.surface.inParameters() && task.boundary.closedInParameters &&
         !hasTwoSheets(task.boundary.input);
}

FilledFace fillFace(const FaceTask& task) { return Filling(task).fill(); }

}  // namespace af2::geometry
