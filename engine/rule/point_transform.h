// How a rule places a point: the open form, and the affine form that almost every rule uses.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/point.h"
#include "engine/rule/binding.h"

namespace af2 {

/// Places a new vertex or a zone corner from the matched vertices.
///
/// Derive from this for a placement that the rule language cannot express. Must be pure: the same
/// binding gives the same point. Source: [VanderZee16], point transforms.
class AF2_EXPORT AF2PointTransform {
 public:
  virtual ~AF2PointTransform() = default;
  /// No value where the placement has none at this match; the match is then refused. Throws
  /// InputError if the binding has fewer vertices than the transform needs.
  virtual std::optional<Point2> transformPoint(const AF2Binding& binding) const = 0;
};

/// An affine function of the matched coordinates:
/// x = constant.x + sum (xx X_i + xy Y_i), y = constant.y + sum (yx X_i + yy Y_i).
class AF2_EXPORT AffinePointTransform final : public AF2PointTransform {
 public:
  /// The contribution of one matched vertex; vertices that contribute nothing are left out.
  struct Term {
    int vertex = 0;
    double xx = 0, xy = 0, yx = 0, yy = 0;
    bool operator==(const Term&) const = default;
  };

  /// Terms are kept in order of vertex; several terms of one vertex are added. Throws InputError on
  /// a negative vertex or a coefficient that is not finite.
  AffinePointTransform(Point2 constant, std::vector<Term> terms);

  /// The matched vertex itself.
  static AffinePointTransform vertex(int index);

  /// The published form, `point` + coefficients * deviations from the reference positions:
  /// x = point.x + sum (xCoefficients[2i] dx_i + xCoefficients[2i+1] dy_i), y likewise.
  /// Throws InputError unless both lists are twice as long as `reference`.
  static AffinePointTransform fromDeviations(Point2 point, std::span<const Point2> reference,
                                             std::span<const double> xCoefficients,
                                             std::span<const double> yCoefficients);

  std::optional<Point2> transformPoint(const AF2Binding& binding) const override;

  /// t * this + (1 - t) * other, coefficient by coefficient.
  AffinePointTransform blend(const AffinePointTransform& other, double t) const;

  Point2 constant() const { return constant_; }
  std::span<const Term> terms() const { return terms_; }
  /// One more than the largest vertex used.
  int vertexCount() const { return terms_.empty() ? 0 : terms_.back().vertex + 1; }
  bool operator==(const AffinePointTransform& other) const {
    return constant_ == other.constant_ && terms_ == other.terms_;
  }

 private:
  Point2 constant_;
  std::vector<Term> terms_;
};

}  // namespace af2
