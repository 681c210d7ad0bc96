#include "engine/run/loop_path.h"

#include <algorithm>
#include <cmath>

#include "engine/base/error.h"
#include "engine/base/segment.h"
#include "engine/base/turn.h"
#include "engine/rule/rule_at_match.h"
#include "engine/step/surroundings.h"

namespace af2 {
namespace {

/// Of a longer loop only so many places are tried, evenly spread.
constexpr std::size_t kMaxStarts = 60;
constexpr int kShortestToDivide = 6;

class PathSearch {
 public:
  PathSearch(const Advance& advance, const CompiledRules& rules, const SizeField& size,
             const std::vector<std::uint8_t>& valence)
      : advance_(advance), rules_(rules), size_(size), valence_(valence) {}

  std::optional<LoopPath> find() {
    loop_ = shortestLoop();
    const std::size_t step = 1 + loop_.size() / kMaxStarts;
    for (std::size_t i = 0; i < loop_.size(); i += step) tryFrom(i);
    return best_;
  }

 private:
  const Front& front() const { return advance_.front; }

  std::vector<PlaceId> shortestLoop() const {
    PlaceId first;
    for (std::size_t i = 0; i < front().capacity(); ++i) {
      const PlaceId id(i);
      if (!front().hasEdge(id) || front().loopSize(id) < kShortestToDivide) continue;
      if (first.isNone() || front().loopSize(id) < front().loopSize(first)) first = id;
    }
    std::vector<PlaceId> loop;
    if (first.isNone()) return loop;
    for (PlaceId id = first; loop.empty() || id != first; id = front().next(id)) loop.push_back(id);
    return loop;
  }

  void tryFrom(std::size_t start) {
    const PlaceId base = loop_[start];
    try {
      const StepChart chart = advance_.chartAt(base, slot_);
      DrawnBase drawn;
      drawn.draw(front(), chart, base);
      std::vector<Point2> at;
      Window window;
      for (const PlaceId id : loop_) {
        at.push_back(chart.positionOf(front()[id].point));
        window.include(at.back().x, at.back().y);
      }
      near_.gather(front(), advance_.index, chart, base, window.widened(1));
      const int level = rules_.set().maxLevel();
      const StepView view{
          front(), near_, chart, drawn, base, level, rules_.set().matchTolerance(level)};
      for (std::size_t end = 0; end < loop_.size(); ++end) {
        const std::size_t away = (end + loop_.size() - start) % loop_.size();
        if (away < 3 || away + 3 > loop_.size()) continue;
        if (!isFree(view, at[start], at[end], loop_[end])) continue;
        for (const CompiledRule& rule : rules_.rules())
          if (rule.rule->definition().path) offer(view, rule, loop_[end], away, at[end]);
      }
    } catch (const GeometryError&) {
      // No chart here: no path from here.
    }
  }

  static bool leavesInto(Point2 center, Point2 next, Point2 previous, Point2 to) {
    return turnBetween(next - center, to - center) < turnBetween(next - center, previous - center);
  }

  bool isFree(const StepView& view, Point2 from, Point2 to, PlaceId end) const {
    const auto at = [&](PlaceId id) { return view.chart.positionOf(front()[id].point); };
    if (view.chart.project(front()[end].point).view != ChartView::Legal) return false;
    if (!leavesInto(from, at(front().next(view.base)), at(front().previous(view.base)), to) ||
        !leavesInto(to, at(front().next(end)), at(front().previous(end)), from))
      return false;
    const VertexId a = front()[view.base].vertex, c = front()[end].vertex;
    return std::ranges::none_of(near_.edges(), [&](const Neighborhood::Edge& edge) {
      const VertexId other = front()[edge.isEdge ? front().next(edge.place) : edge.place].vertex;
      if (edge.vertex == a || edge.vertex == c || other == a || other == c) return false;
      return doCross(from, to, edge.from, edge.to) ||
             distanceToSegment(edge.from, from, to) < kSame;
    });
  }

  void offer(const StepView& view, const CompiledRule& rule, PlaceId end, std::size_t away,
             Point2 to) {
    const RuleDefinition& definition = rule.rule->definition();
    Match match;
    match.places = {view.base, front().next(view.base), end};
    match.points[1] = view.drawn.b.point.position;
    match.points[2] = to;
    const FrontSurroundings surroundings(view, advance_.index, *rule.rule, match, size_, valence_);
    const AF2Binding binding{{match.points.data(), 3}, view.level, &surroundings};
    if (!failedRequirement(definition, binding).isNone()) return;
    const auto wanted = definition.path->segments->evaluate(binding);
    const auto cost = costAt(definition, binding);
    if (!wanted || !std::isfinite(*wanted) || !cost) return;
    const std::size_t segments = fittingSegments(*wanted, away);
    // Both parts must be shorter than the loop, or paths could go on for ever.
    if (away + segments >= loop_.size() || loop_.size() - away + segments >= loop_.size()) return;
    if (best_ && *cost >= best_->score) return;
    LoopPath path{&rule, view.base, end, {}, *cost};
    for (std::size_t k = 1; k < segments; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(segments);
      const auto point = view.chart.lift(t * to);
      if (!point) return;
      path.points.push_back(*point);
    }
    best_ = std::move(path);
  }

  /// The number nearest to the wanted one that makes both parts of an even loop even.
  static std::size_t fittingSegments(double wanted, std::size_t away) {
    const std::size_t parity = away % 2;
    const double least = parity == 1 ? 1 : 2;
    const double pairs = std::round((std::max(wanted, least) - static_cast<double>(parity)) / 2);
    return 2 * static_cast<std::size_t>(std::min(pairs, 1e6)) + parity;
  }

  static constexpr double kSame = 1e-9;

  const Advance& advance_;
  const CompiledRules& rules_;
  const SizeField& size_;
  const std::vector<std::uint8_t>& valence_;
  ChartSlot slot_;
  Neighborhood near_;
  std::vector<PlaceId> loop_;
  std::optional<LoopPath> best_;
};

}  // namespace

std::optional<LoopPath> bestPath(const Advance& advance, const CompiledRules& rules,
                                 const SizeField& size, const std::vector<std::uint8_t>& valence) {
  const bool hasPaths = std::ranges::any_of(
      rules.rules(), [](const CompiledRule& r) { return r.rule->definition().path.has_value(); });
  if (!hasPaths) return std::nullopt;
  return PathSearch(advance, rules, size, valence).find();
}

}  // namespace af2
