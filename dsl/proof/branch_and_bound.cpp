#include "dsl/proof/branch_and_bound.h"

#include <algorithm>
#include <cmath>

#include "dsl/program/box_run.h"

namespace af2::dsl {
namespace {

/// Rounding allowances: a value above minus kClaimRounding counts as non-negative. Facts may be
/// violated by the tolerance of the convexity test times the length of a chord.
constexpr double kClaimRounding = 1e-7, kFactRounding = 1e-8;

/// A strict claim must exceed this value somewhere in each box.
constexpr double kFlat = 1e-6;

using Steps = std::vector<std::size_t>;

/// A claim about steps of a program.
struct StepClaim {
  Claim::Kind kind;
  std::size_t step = 0;
  std::vector<StepClaim> parts;
};

class Search {
 public:
  Search(const RuleGraph& graph, const Claim& claim, const Circumstances& given)
      : graph_(graph),
        isStrict_(given.isStrict),
        program_(programOf(claim, given)),
        run_(program_, graph.variables()) {}

  bool holds(ProofEffort& effort) {
    Box whole;
    for (const BoxVariable& variable : graph_.variables()) whole.push_back(variable.range);
    std::vector<Box> open{std::move(whole)};
    while (!open.empty()) {
      if (effort.mostBoxes == 0) return false;
      --effort.mostBoxes;
      Box box = std::move(open.back());
      open.pop_back();
      run_.run(box);
      if (isEmpty()) continue;
      undecided_.reset();
      if (holdsHere(claim_)) continue;
      const auto side = sideToCut(box);
      if (!side || box[*side].width() < effort.smallestSide) return false;
      Box upper = box;
      box[*side].high = upper[*side].low = box[*side].middle();
      open.push_back(std::move(box));
      open.push_back(std::move(upper));
    }
    return true;
  }

 private:
  Program programOf(const Claim& claim, const Circumstances& given) {
    std::vector<Node> nodes;
    const auto add = [&](Steps& steps, const std::vector<Node>& list) {
      for (const Node node : list) {
        steps.push_back(nodes.size());
        nodes.push_back(node);
      }
    };
    add(facts_, graph_.facts());
    add(facts_, given.facts);
    add(truths_, graph_.truths());
    add(truths_, given.truths);
    add(untruths_, given.untruths);
    claim_ = placed(claim, nodes);
    Program program = graph_.program(nodes);
    const auto results = program.results();
    for (Steps* steps : {&facts_, &truths_, &untruths_})
      for (std::size_t& step : *steps) step = static_cast<std::size_t>(results[step]);
    resolve(claim_, results);
    return program;
  }

  StepClaim placed(const Claim& claim, std::vector<Node>& nodes) {
    StepClaim result{claim.kind, nodes.size(), {}};
    if (claim.kind == Claim::Kind::NotNegative) nodes.push_back(claim.node);
    for (const Claim& part : claim.parts) result.parts.push_back(placed(part, nodes));
    return result;
  }

  void resolve(StepClaim& claim, std::span<const Node> results) {
    if (claim.kind == Claim::Kind::NotNegative)
      claim.step = static_cast<std::size_t>(results[claim.step]);
    for (StepClaim& part : claim.parts) resolve(part, results);
  }

  /// Whether the box contains no match.
  bool isEmpty() const {
    const auto isMissed = [&](std::size_t step) { return run_.value(step).high < -kFactRounding; };
    const auto isFalse = [&](std::size_t step) { return run_.value(step).isZero(); };
    const auto isTrue = [&](std::size_t step) { return !run_.value(step).contains(0); };
    return std::ranges::any_of(facts_, isMissed) || std::ranges::any_of(truths_, isFalse) ||
           std::ranges::any_of(untruths_, isTrue);
  }

  bool holdsHere(const StepClaim& claim) {
    const auto holds = [&](const StepClaim& part) { return holdsHere(part); };
    switch (claim.kind) {
      case Claim::Kind::All:
        return std::ranges::all_of(claim.parts, holds);
      case Claim::Kind::Any:
        return std::ranges::any_of(claim.parts, holds);
      case Claim::Kind::NotNegative:
        break;
    }
    const bool isShown = isNotNegative(claim.step);
    if (!isShown && !undecided_) undecided_ = claim.step;
    return isShown;
  }

  bool isNotNegative(std::size_t step) const {
    if (std::ranges::find(facts_, step) != facts_.end()) return true;
    const Interval value = run_.value(step);
    if (value.low > 0) return true;
    if (isStrict_ && !(value.high > kFlat)) return false;
    if (value.low >= -kClaimRounding) return true;
    return std::ranges::any_of(facts_, [&](std::size_t fact) { return exceeds(step, fact); });
  }

  /// Whether the step exceeds a multiple of a fact. The multiple is chosen so that the difference
  /// has no slope along the slope of the fact.
  bool exceeds(std::size_t step, std::size_t fact) const {
    double along = 0, size = 0;
    for (std::size_t v = 0; v < graph_.variables().size(); ++v) {
      const double own = run_.slope(step, v).middle(), other = run_.slope(fact, v).middle();
      along += own * other;
      size += other * other;
    }
    const double factor = along / size;
    if (!(factor > 0) || !std::isfinite(factor)) return false;
    return run_.differenceOf(step, factor, fact).low - factor * kFactRounding >= -kClaimRounding;
  }

  /// The side along which the undecided step changes most; the longest side if this is not known.
  std::optional<std::size_t> sideToCut(const Box& box) const {
    std::optional<std::size_t> best, longest;
    double most = 0;
    for (std::size_t v = 0; v < box.size(); ++v) {
      if (!longest || box[v].width() > box[*longest].width()) longest = v;
      const Interval slope = undecided_ ? run_.slope(*undecided_, v) : Interval{};
      const double change = box[v].width() * std::max(std::abs(slope.low), std::abs(slope.high));
      if (!std::isfinite(change)) return longestChanging(box);
      if (change <= most) continue;
      most = change;
      best = v;
    }
    return best ? best : longest;
  }

  /// The longest side along which the undecided step changes.
  std::optional<std::size_t> longestChanging(const Box& box) const {
    std::optional<std::size_t> longest;
    for (std::size_t v = 0; v < box.size(); ++v)
      if (!run_.slope(*undecided_, v).isZero() &&
          (!longest || box[v].width() > box[*longest].width()))
        longest = v;
    return longest;
  }

  const RuleGraph& graph_;
  bool isStrict_;
  Steps facts_, truths_, untruths_;
  StepClaim claim_{Claim::Kind::All, 0, {}};
  Program program_;
  BoxRun run_;
  std::optional<std::size_t> undecided_;  // the first step not shown to be non-negative
};

}  // namespace

bool holdsEverywhere(const RuleGraph& graph, const Claim& claim, const Circumstances& given,
                     ProofEffort& effort) {
  return claim.isTrue() || Search(graph, claim, given).holds(effort);
}

}  // namespace af2::dsl
