#include "dsl/program/least_value.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "dsl/program/box_run.h"

namespace af2::dsl {
namespace {

/// Bounds of the steps of a program, as far as they are asked for.
class Bounds {
 public:
  Bounds(const Program& program, int level)
      : steps_(program.steps()), level_(level), known_(steps_.size()) {}

  Interval of(Node node) {
    auto& known = known_[index(node)];
    if (!known) known = computed(step(node));
    return *known;
  }

  /// Bounds of `node` where `limited` lies within a range.
  Interval of(Node node, Node limited, Interval range) const {
    Bounds inside(*this);
    // What has been computed may depend on the limited step.
    std::fill(inside.known_.begin() + limited, inside.known_.end(), std::nullopt);
    inside.known_[index(limited)] = range;
    inside.depth_ = depth_ + 1;
    return inside.of(node);
  }

 private:
  /// Each choice within another doubles the work.
  static constexpr int kDeepest = 6;

  static std::size_t index(Node node) { return static_cast<std::size_t>(node); }
  const Step& step(Node node) const { return steps_[index(node)]; }

  Interval computed(const Step& s) {
    if (s.op == Op::Level) return Interval::point(level_);
    if (s.op == Op::Select) return choice(s);
    std::array<Interval, 4> arguments{};
    for (std::size_t i = 0; i < arguments.size() && s.arguments[i] >= 0; ++i)
      arguments[i] = of(s.arguments[i]);
    Interval bounds = boundsOf(s, arguments);
    if (s.op == Op::Add || s.op == Op::Maximum)
      if (const auto root = leastWithInverse(s)) {
        const double least = s.op == Op::Add ? 2 * *root : *root;
        bounds.low = std::max(bounds.low, least);
        bounds.high = std::max(bounds.low, bounds.high);
      }
    return bounds;
  }

  /// For x and c/x with x >= 0, c > 0: the square root of c, at which their maximum and half of
  /// their sum are least; a little less, because of rounding.
  std::optional<double> leastWithInverse(const Step& s) {
    for (const auto& [x, inverse] :
         {std::pair{s.arguments[0], s.arguments[1]}, std::pair{s.arguments[1], s.arguments[0]}}) {
      const Step& ratio = step(inverse);
      if (ratio.op != Op::Divide || ratio.arguments[1] != x) continue;
      const Interval c = of(ratio.arguments[0]);
      if (c.low > 0 && of(x).low >= 0) return std::sqrt(c.low) * (1 - 1e-15);
    }
    return std::nullopt;
  }

  Interval choice(const Step& s) {
    const Interval condition = of(s.arguments[0]);
    if (!condition.contains(0)) return of(s.arguments[1]);
    if (condition.isZero()) return of(s.arguments[2]);
    return hull(branch(s, 1), branch(s, 2));
  }

  /// A branch of a choice by p < q or p <= q, where one of the two is limited by the other.
  Interval branch(const Step& s, std::size_t which) {
    const Node taken = s.arguments[which];
    const Step& condition = step(s.arguments[0]);
    const bool isComparison = condition.op == Op::Less || condition.op == Op::LessEqual;
    if (isNone(taken)) return of(s.arguments[3 - which]);
    if (!isComparison || depth_ >= kDeepest) return of(taken);
    const Node p = condition.arguments[0], q = condition.arguments[1];
    const bool isLess = which == 1;
    const Interval ofP = of(p), ofQ = of(q);
    if (step(p).op == Op::Constant)
      return of(taken, q, isLess ? atLeast(ofQ, ofP.low) : atMost(ofQ, ofP.high));
    return of(taken, p, isLess ? atMost(ofP, ofQ.high) : atLeast(ofP, ofQ.low));
  }

  /// A branch without a value does not count.
  bool isNone(Node node) const {
    return step(node).op == Op::Constant && std::isnan(step(node).constant);
  }

  static Interval atLeast(Interval a, double low) {
    return {std::max(a.low, low), std::max(a.high, low)};
  }
  static Interval atMost(Interval a, double high) {
    return {std::min(a.low, high), std::min(a.high, high)};
  }

  std::span<const Step> steps_;
  int level_;
  std::vector<std::optional<Interval>> known_;
  int depth_ = 0;
};

}  // namespace

double leastValue(const Program& program, int level) {
  const double least = Bounds(program, level).of(program.results()[0]).low;
  return std::isnan(least) ? -Interval::kInfinity : least;
}

}  // namespace af2::dsl
