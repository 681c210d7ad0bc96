#include "engine/run/observed_step.h"

#include <algorithm>

namespace af2 {

LocalFront frontAround(const Front& front, const StepChart& chart, PlaceId base) {
  constexpr double kReach = 4;  // sizes
  const double size = 0.5 * (front[base].size + front[front.next(base)].size) / chart.unit();
  return localFront(front, chart, base, size, kReach * std::max(size, 1.0));
}

ObservedStep::ObservedStep(AF2MeshingObserver& observer, const Front& front, PlaceId base)
    : observer_(observer), front_(front), base_(base) {
  const Place &from = front[base], &to = front[from.next];
  report_.from = from.vertex;
  report_.to = to.vertex;
  report_.fromPoint = from.point.position;
  report_.toPoint = to.point.position;
  report_.level = from.level;
}

void ObservedStep::look(CandidateChoice& choice, const StepChart& chart) {
  if (observer_.wantsRefusals()) refusals_ = choice.explain(chart, base_);
  if (observer_.wantsFrontAround(report_)) around_ = frontAround(front_, chart, base_);
}

void ObservedStep::note(const Application& application) {
  report_.applied = true;
  report_.rule = application.rule->index;
  report_.score = application.score;
}

void ObservedStep::tell(const Mesh& mesh) {
  report_.elements = mesh.elements.size();
  report_.frontEdges = front_.edgeCount();
  if (report_.applied)
    std::erase_if(refusals_, [&](const RuleRefusal& r) {
      if (r.rule != report_.rule) return false;
      report_.ruleSeconds = r.seconds;
      return true;
    });
  observer_.stepTaken(report_);
  if (report_.applied) observer_.meshGrown(report_, mesh);
  if (observer_.wantsRefusals()) observer_.rulesRefused(report_, refusals_);
  if (around_) observer_.frontAround(report_, *around_);
}

}  // namespace af2
