// Parameters at which an edge crosses boundaries, compared exactly.
#pragma once

#include <optional>
#include <utility>

#include "dsl/shapes/curve.h"
#include "engine/base/point.h"

namespace af2::dsl::shapes {

/// A directed edge under test: from + t (to - from), 0 <= t <= 1.
struct Edge {
  Point2 from, to;
};

/// a t^2 + b t + c.
template <class N>
struct Quadratic {
  N a{}, b{}, c{};
};

/// The number (n + s sqrt(radicand)) / d; d > 0, radicand >= 0.
template <class N>
struct RootForm {
  N n{}, s{}, radicand{}, d{};
};

/// f of a smooth set along an edge.
template <class N>
Quadratic<N> along(const Curve<N>& curve, const Edge& edge) {
  const Vector<N> w = difference<N>(edge.from, edge.to);
  return {N(0) - curve.bend * dot(w, w), dot(gradientAt(curve, edge.from), w),
          valueAt(curve, edge.from)};
}

/// A parameter t of an edge: that of a point on its line, or of a crossing with a smooth boundary.
///
/// Stores bounds in doubles and the definition of the parameter, so that it can be computed exactly
/// if the bounds do not decide.
class Crossing {
 public:
  /// The foot of `point` on the line of the edge.
  static Crossing atPoint(const Edge& edge, Point2 point);
  /// The crossing with a line that is not parallel to the edge.
  static Crossing withLine(const Edge& edge, const HalfPlane& line);
  /// The crossings with a circle, the lower one first; twice the same if the edge touches it.
  static std::optional<std::pair<Crossing, Crossing>> withCircle(const Edge& edge,
                                                                 const SmoothSet& disc);
  static Crossing start(const Edge& edge) { return atPoint(edge, edge.from); }
  static Crossing end(const Edge& edge) { return atPoint(edge, edge.to); }

  /// The sign of *this - other, both on `edge`. Exact.
  int compare(const Crossing& other, const Edge& edge) const;

  /// The side of the boundary of `plane` on which the crossing lies: 1 inside, 0 on it. Exact.
  int sideOf(const HalfPlane& plane, const Edge& edge) const;

  /// The given point, if the parameter was made from one.
  std::optional<Point2> point() const {
    if (root_ != Root::Point) return std::nullopt;
    return std::get<HalfPlane>(boundary_).point;
  }
  /// The parameter, rounded.
  double approximate() const { return low_ + 0.5 * (high_ - low_); }

 private:
  enum class Root { Point, Line, Touch, Lower, Upper };
  Crossing(Root root, SmoothSet boundary) : root_(root), boundary_(boundary) {}
  void enclose(const Edge& edge);
  template <class N>
  RootForm<N> form(const Edge& edge) const;

  double low_ = 0, high_ = 0;
  Root root_ = Root::Point;
  SmoothSet boundary_;  // Root::Point: a half plane through the point
};

}  // namespace af2::dsl::shapes
