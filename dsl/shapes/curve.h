// The smooth sets in shapes: half planes and discs, with the polynomials that bound them.
#pragma once

#include <algorithm>
#include <limits>
#include <variant>

#include "dsl/shapes/exact.h"
#include "engine/base/point.h"

namespace af2::dsl::shapes {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline bool liesBetween(Point2 p, Point2 a, Point2 b) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

/// The half plane left of the line through `point` along tip - tail.
struct HalfPlane {
  Point2 point, tail, tip;
  bool isChord = false;  ///< of an arc point -> tip: only the part between the ends of the chord
                         ///< can be boundary
  bool operator==(const HalfPlane&) const = default;
};

struct Disc {
  Point2 centre;
  double radius = 0;  ///< > 0
  bool operator==(const Disc&) const = default;
};

/// The disc whose circle passes through three points that turn left.
struct DiscThrough {
  Point2 a, b, c;
  bool operator==(const DiscThrough&) const = default;
};

using SmoothSet = std::variant<HalfPlane, Disc, DiscThrough>;

/// f = constant + gradient.y - bend |y|^2 with y = x - origin; positive inside, bend >= 0.
template <class N>
struct Curve {
  Point2 origin;
  N constant{};
  Vector<N> gradient{};
  N bend{};
};

template <class N>
Curve<N> curveOf(const HalfPlane& plane) {
  const Vector<N> v = difference<N>(plane.tail, plane.tip);
  return {plane.point, N(0), {N(0) - v.y, v.x}, N(0)};
}

template <class N>
Curve<N> curveOf(const Disc& disc) {
  return {disc.centre, N(disc.radius) * N(disc.radius), {}, N(1)};
}

template <class N>
Curve<N> curveOf(const DiscThrough& disc) {
  const Vector<N> u = difference<N>(disc.a, disc.b), s = difference<N>(disc.a, disc.c);
  const N uu = dot(u, u), ss = dot(s, s);
  return {disc.a, N(0), {uu * s.y - ss * u.y, ss * u.x - uu * s.x}, cross(u, s)};
}

template <class N>
Curve<N> curveOf(const SmoothSet& set) {
  return std::visit([](const auto& one) { return curveOf<N>(one); }, set);
}

/// f at a point.
template <class N>
N valueAt(const Curve<N>& curve, Point2 point) {
  const Vector<N> y = difference<N>(curve.origin, point);
  return curve.constant + dot(curve.gradient, y) - curve.bend * dot(y, y);
}

/// The gradient of f at a point; it points inside.
template <class N>
Vector<N> gradientAt(const Curve<N>& curve, Point2 point) {
  const Vector<N> y = difference<N>(curve.origin, point);
  const N twice = N(2) * curve.bend;
  return {curve.gradient.x - twice * y.x, curve.gradient.y - twice * y.y};
}

/// The sign of f at a point: 1 inside, 0 on the boundary, -1 outside.
inline int sideOf(const SmoothSet& set, Point2 point) {
  return signOf([&]<class N>() { return valueAt(curveOf<N>(set), point); });
}

/// The sign of the turn from the direction of one half plane's line to that of another.
inline int turnOf(const HalfPlane& p, const HalfPlane& q) {
  return signOf(
      [&]<class N>() { return cross(difference<N>(p.tail, p.tip), difference<N>(q.tail, q.tip)); });
}

/// Whether the directions of two lines make less than a right angle.
inline bool headsAlong(const HalfPlane& p, const HalfPlane& q) {
  return signOf([&]<class N>() {
           return dot(difference<N>(p.tail, p.tip), difference<N>(q.tail, q.tip));
         }) > 0;
}

}  // namespace af2::dsl::shapes
