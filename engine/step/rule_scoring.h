// The score of what a match of a rule would make. Used by the front for its matches, and by callers
// that evaluate a rule without a front.
// Not installed.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "engine/mesh/element_measures.h"
#include "engine/mesh/element_shape.h"
#include "engine/rule/refusal.h"
#include "engine/rule/rule_set.h"

namespace af2 {

/// Chart positions of an element's corners.
class ElementCorners {
 public:
  /// vertices  of the match: the matched ones, then the new ones
  ElementCorners(const RuleElement& element, const Point2* vertices) : count_(element.size()) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(count_); ++i)
      points_[i] = vertices[static_cast<std::size_t>(element.corners[i])];
  }
  const Point2& operator[](std::size_t i) const { return points_[i]; }
  int count() const { return count_; }
  std::span<const Point2> span() const {
    return {points_.data(), static_cast<std::size_t>(count_)};
  }

 private:
  std::array<Point2, 4> points_;
  int count_;
};

/// Computes the scores that a rule set gives to its rules' results; keeps the metric's fast form.
class RuleScoring {
 public:
  /// Keeps a reference to `set`.
  explicit RuleScoring(const RuleSetDefinition& set)
      : set_(set),
        fastMetric_(dynamic_cast<const ShapeSizeMetric*>(set.metric.get())),
        needsMeasures_(set.acceptance && set.acceptance->needsMeasures()) {}

  /// Whether the rule set accepts quadrilaterals with a reflex corner, which are mended when the
  /// front has closed.
  [[gnu::noinline]] bool allowsReflexAt(int level) const {
    return needsMeasures_ && set_.acceptance->acceptsMeasured(kBestScore, level, kReflex);
  }

  /// The combined badness of the new elements. Returns Inverted if an element does not turn left at
  /// each corner, or at all but one where that is allowed, NoValue if one has no finite badness,
  /// else None.
  ///
  /// Inline because the front calls it for every match.
  Refusal scoreElements(const std::vector<RuleElement>& elements, const Point2* vertices, int level,
                        double& score) const {
    double largest = 0, sum = 0;
    bool isFirst = true;
    for (const RuleElement& element : elements) {
      const ElementCorners corners(element, vertices);
      if (!turnsLeftEverywhere(corners.span()) && !isAllowedReflex(corners, level))
        return Refusal::Inverted;
      const double badness = badnessOf(corners, level);
      if (!std::isfinite(badness)) return Refusal::NoValue;
      largest = isFirst ? badness : std::max(largest, badness);
      sum += badness;
      isFirst = false;
    }
    switch (set_.scoreOf) {
      case ScoreOf::Max:
        score = largest;
        break;
      case ScoreOf::Sum:
        score = sum;
        break;
      case ScoreOf::Mean:
        score = elements.empty() ? 0 : sum / static_cast<double>(elements.size());
        break;
    }
    return Refusal::None;
  }

  /// A lower bound of the scores that a rule can have at a level.
  double leastScore(const RuleDefinition& rule, int level) const {
    constexpr double kRounding = 1e-12;
    double largest = 0, sum = 0;
    for (const RuleElement& element : rule.elements) {
      const double least = set_.metric->leastAt(element.size(), level);
      largest = &element == &rule.elements.front() ? least : std::max(largest, least);
      sum += least;
    }
    const auto count = static_cast<double>(std::max<std::size_t>(rule.elements.size(), 1));
    const double ofElements = set_.scoreOf == ScoreOf::Max   ? largest
                              : set_.scoreOf == ScoreOf::Sum ? sum
                                                             : sum / count;
    const double least = ofElements + (rule.cost ? rule.cost->leastAt(level) : 0);
    return std::isnan(least) ? -INFINITY : least - kRounding * (1 + std::abs(least));
  }

  /// Score if the rule set does not accept the score or the shapes of the elements, else None.
  Refusal judge(const std::vector<RuleElement>& elements, const Point2* vertices, double score,
                int level) const {
    if (!set_.acceptance) return Refusal::None;
    const bool isGood = needsMeasures_ ? set_.acceptance->acceptsMeasured(
                                             score, level, measuresOf(elements, vertices))
                                       : set_.acceptance->accepts(score, level);
    return isGood ? Refusal::None : Refusal::Score;
  }

 private:
  /// Badness of an element that turns left everywhere; infinite if it has no value.
  double badnessOf(const ElementCorners& corners, int level) const {
    if (fastMetric_ && corners.count() == 3)
      return fastMetric_->triangleBadness(corners[0], corners[1], corners[2]);
    return set_.metric->badnessAt(corners.span(), level).value_or(INFINITY);
  }

  bool isAllowedReflex(const ElementCorners& corners, int level) const {
    return needsMeasures_ && allowsReflexAt(level) && hasOneReflexCorner(corners.span());
  }

  static constexpr double kBestScore = -1e9;
  static constexpr ElementMeasures kReflex{-1e-3, 1e-3};

  /// Not inlined, so that sets that accept by the score alone do not pay for it.
  [[gnu::noinline]] static ElementMeasures measuresOf(const std::vector<RuleElement>& elements,
                                                      const Point2* vertices) {
    ElementMeasures worst;
    for (const RuleElement& element : elements) {
      const ElementCorners corners(element, vertices);
      worst.scaledJacobian = std::min(worst.scaledJacobian, scaledJacobian(corners.span()));
      worst.minAngle = std::min(worst.minAngle, smallestAngle(corners.span()));
    }
    return worst;
  }

  const RuleSetDefinition& set_;
  const ShapeSizeMetric* fastMetric_;
  bool needsMeasures_;
};

}  // namespace af2
