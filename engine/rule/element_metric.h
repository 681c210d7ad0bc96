// The quality of a new element, and when a rule's result is good enough.
#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/point.h"

namespace af2 {

/// Badness of one element in the chart: 0 for the ideal element, unbounded above.
class AF2_EXPORT AF2ElementMetric {
 public:
  virtual ~AF2ElementMetric() = default;
  /// corners  three or four, positively oriented, in chart units
  /// No value where the metric is undefined; the match is then refused.
  virtual std::optional<double> badness(std::span<const Point2> corners) const = 0;
  /// The same at a quality level of the base edge, for metrics that depend on it.
  virtual std::optional<double> badnessAt(std::span<const Point2> corners, int /*level*/) const {
    return badness(corners);
  }
  /// A lower bound of the badness of elements with this number of corners at a quality level.
  virtual double leastAt(int /*corners*/, int /*level*/) const { return -INFINITY; }
};

/// weight * (sqrt(3)/36 * perimeter^2/area - 1) + sum over the edges (length + 1/length - 2);
/// for quadrilaterals perimeter^2/area is compared with that of the square.
/// Source: the triangle measure of [Schoeberl97].
class AF2_EXPORT ShapeSizeMetric final : public AF2ElementMetric {
 public:
  explicit ShapeSizeMetric(double weight) : weight_(weight) {}
  std::optional<double> badness(std::span<const Point2> corners) const override;
  /// badness({a, b, c}), bit for bit; not finite where that has no value.
  double triangleBadness(Point2 a, Point2 b, Point2 c) const {
    const double doubleArea = cross(b - a, c - a);
    if (!(doubleArea > 0)) return INFINITY;
    const double ab = distance(a, b), bc = distance(b, c), ca = distance(c, a);
    const double perimeter = ab + bc + ca;
    const double size = (ab + 1 / ab - 2) + (bc + 1 / bc - 2) + (ca + 1 / ca - 2);
    return weight_ * (perimeter * perimeter / (0.5 * doubleArea * kTrianglePerimeterRatio) - 1) +
           size;
  }
  double leastAt(int /*corners*/, int /*level*/) const override {
    return weight_ < 0 ? -INFINITY : 0;
  }
  double weight() const { return weight_; }

 private:
  /// Perimeter^2 / area of the equilateral triangle, the minimum over all triangles: 12 sqrt(3).
  static constexpr double kTrianglePerimeterRatio = 20.784609690826528;

  double weight_;
};

/// How the badnesses of the elements of one rule combine into one score.
enum class ScoreOf { Max, Sum, Mean };

/// The shapes of the new elements of a rule, in the chart: of each measure the worst value. By
/// default those of ideal quadrilaterals.
struct ElementMeasures {
  double scaledJacobian = 1;  ///< the smallest sine of a corner; of a triangle, times 2/sqrt(3)
  double minAngle = 0.5 * std::numbers::pi;  ///< radians
};

/// Whether a rule's result is good enough at a level. Lower scores are better.
class AF2_EXPORT AF2Acceptance {
 public:
  virtual ~AF2Acceptance() = default;
  virtual bool accepts(double score, int level) const = 0;
  /// Whether the shapes of the new elements count, too; then `acceptsMeasured` decides.
  virtual bool needsMeasures() const { return false; }
  virtual bool acceptsMeasured(double score, int level, const ElementMeasures&) const {
    return accepts(score, level);
  }
};

/// score < bound[level], the usual acceptance.
class AF2_EXPORT ScoreBound final : public AF2Acceptance {
 public:
  /// bounds  by level; [0] is level 1; the last one applies to all higher levels
  explicit ScoreBound(std::vector<double> bounds);
  bool accepts(double score, int level) const override;

 private:
  std::vector<double> bounds_;
};

}  // namespace af2
