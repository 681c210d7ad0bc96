#include "dsl/shapes/crossing.h"

#include <algorithm>
#include <cmath>

namespace af2::dsl::shapes {
namespace {

struct Interval {
  double low, high;
};

Interval outward(double low, double high) {
  return {std::nextafter(low, -kInfinity), std::nextafter(high, kInfinity)};
}

Interval intervalOf(Bounded x) { return outward(x.value() - x.error(), x.value() + x.error()); }

/// The square root of a number that is known to be >= 0.
Interval squareRoot(Bounded x) {
  const Interval square = intervalOf(x);
  return outward(std::sqrt(std::max(0.0, square.low)), std::sqrt(std::max(0.0, square.high)));
}

/// x / d for d > 0; all numbers if the bounds do not prove d > 0.
Interval quotient(Interval x, Interval d) {
  if (!(d.low > 0)) return {-kInfinity, kInfinity};
  return outward(x.low / (x.low < 0 ? d.low : d.high), x.high / (x.high > 0 ? d.low : d.high));
}

/// The sign of p - q.
int compareForms(const RootForm<Dyadic>& p, const RootForm<Dyadic>& q) {
  // (p - q) p.d q.d = a + b sqrt(p.radicand) + c sqrt(q.radicand)
  const Dyadic a = p.n * q.d - q.n * p.d;
  const Dyadic b = p.s * q.d;
  const Dyadic c = Dyadic(0) - q.s * p.d;
  const int first = signWithRoot(a, b, p.radicand);
  const int second = q.radicand.sign() == 0 ? 0 : c.sign();
  if (first == 0 || second == 0 || first == second) return first != 0 ? first : second;
  // Opposite signs: the larger square decides.
  const Dyadic rational = a * a + b * b * p.radicand - c * c * q.radicand;
  return first * signWithRoot(rational, Dyadic(2) * a * b, p.radicand);
}

}  // namespace

template <class N>
RootForm<N> Crossing::form(const Edge& edge) const {
  if (root_ == Root::Point) {
    const Vector<N> w = difference<N>(edge.from, edge.to);
    const Point2 point = std::get<HalfPlane>(boundary_).point;
    return {dot(difference<N>(edge.from, point), w), N(0), N(0), dot(w, w)};
  }
  const Quadratic<N> f = along(curveOf<N>(boundary_), edge);
  if (root_ == Root::Line) {
    const bool rising = signOf([&]<class M>() { return along(curveOf<M>(boundary_), edge).b; }) > 0;
    return rising ? RootForm<N>{N(0) - f.c, N(0), N(0), f.b}
                  : RootForm<N>{f.c, N(0), N(0), N(0) - f.b};
  }
  const N s = N(root_ == Root::Upper ? 1 : root_ == Root::Lower ? -1 : 0);
  return {f.b, s, f.b * f.b - N(4) * f.a * f.c, N(-2) * f.a};
}

void Crossing::enclose(const Edge& edge) {
  const RootForm<Bounded> t = form<Bounded>(edge);
  if (t.n.isProven() && t.n.sign() == 0 && t.s.sign() == 0) return;  // exactly 0
  Interval n = intervalOf(t.n);
  if (t.s.sign() != 0) {
    const Interval root = squareRoot(t.radicand);
    n = t.s.sign() > 0 ? outward(n.low + root.low, n.high + root.high)
                       : outward(n.low - root.high, n.high - root.low);
  }
  const Interval quotientOf = quotient(n, intervalOf(t.d));
  low_ = quotientOf.low;
  high_ = quotientOf.high;
}

Crossing Crossing::atPoint(const Edge& edge, Point2 point) {
  Crossing crossing(Root::Point, HalfPlane{point, point, point});
  if (point == edge.to) {
    crossing.low_ = crossing.high_ = 1;
  } else {
    crossing.enclose(edge);
  }
  return crossing;
}

Crossing Crossing::withLine(const Edge& edge, const HalfPlane& line) {
  Crossing crossing(Root::Line, line);
  crossing.enclose(edge);
  return crossing;
}

std::optional<std::pair<Crossing, Crossing>> Crossing::withCircle(const Edge& edge,
                                                                  const SmoothSet& disc) {
  const int radicand = signOf([&]<class N>() {
    const Quadratic<N> f = along(curveOf<N>(disc), edge);
    return f.b * f.b - N(4) * f.a * f.c;
  });
  if (radicand < 0) return std::nullopt;
  Crossing lower(radicand == 0 ? Root::Touch : Root::Lower, disc);
  Crossing upper(radicand == 0 ? Root::Touch : Root::Upper, disc);
  lower.enclose(edge);
  upper.enclose(edge);
  return std::pair(lower, upper);
}

int Crossing::compare(const Crossing& other, const Edge& edge) const {
  if (high_ < other.low_) return -1;
  if (low_ > other.high_) return 1;
  if (low_ == high_ && other.low_ == other.high_) return 0;
  if (root_ == other.root_ && boundary_ == other.boundary_) return 0;
  return compareForms(form<Dyadic>(edge), other.form<Dyadic>(edge));
}

int Crossing::sideOf(const HalfPlane& plane, const Edge& edge) const {
  const int from = shapes::sideOf(plane, edge.from), to = shapes::sideOf(plane, edge.to);
  if (from == to && low_ >= 0 && high_ <= 1) return from;
  const RootForm<Dyadic> t = form<Dyadic>(edge);
  const Quadratic<Dyadic> f = along(curveOf<Dyadic>(plane), edge);
  return signWithRoot(f.c * t.d + f.b * t.n, f.b * t.s, t.radicand);
}

}  // namespace af2::dsl::shapes
