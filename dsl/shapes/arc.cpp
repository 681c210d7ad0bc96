#include "dsl/shapes/arc.h"

#include <algorithm>
#include <cmath>

#include "engine/base/elementary.h"
#include "engine/base/predicates.h"

namespace af2::dsl::shapes {
namespace {

/// The same arc in counter-clockwise direction.
struct LeftArc {
  Point2 a, b, c;
  bool reversed = false;
};

LeftArc leftArcOf(const Step& arc) {
  if (orientation(arc.from, *arc.via, arc.to) == Turn::Left) return {arc.from, *arc.via, arc.to};
  return {arc.to, *arc.via, arc.from, true};
}

bool liesInside(Point2 point, const Step& arc) { return sideOf(chordOf(arc), point) > 0; }

/// Intersections of arcs of the same circle.
bool overlap(const Step& s, const Step& t) {
  return liesInside(*s.via, t) || liesInside(s.from, t) || liesInside(s.to, t) ||
         liesInside(*t.via, s) || liesInside(t.from, s) || liesInside(t.to, s);
}

/// A counter-clockwise arc as a + y, y = delta (N.delta) / (D delta.delta): the point of the circle
/// seen from its start `a` along delta = T + t E, from the tangent T (t = 0) to the chord (t = 1).
struct ParametricArc {
  Curve<Dyadic> circle;  ///< origin a, gradient N, bend D
  Vector<Dyadic> tangent, change;
  Dyadic tt, te, ee, ne;  ///< T.T, T.E, E.E, N.E

  explicit ParametricArc(const LeftArc& arc)
      : circle(curveOf<Dyadic>(DiscThrough{arc.a, arc.b, arc.c})) {
    const Vector<Dyadic>& n = circle.gradient;
    tangent = {n.y, Dyadic(0) - n.x};
    const Vector<Dyadic> chord = difference<Dyadic>(arc.a, arc.c);
    change = {chord.x - tangent.x, chord.y - tangent.y};
    tt = dot(tangent, tangent);
    te = dot(tangent, change);
    ee = dot(change, change);
    ne = dot(n, change);
  }

  /// f of a curve along the arc, times D^2 delta.delta > 0: a quadratic in t, since N.T = 0.
  Quadratic<Dyadic> along(const Curve<Dyadic>& f) const {
    const Dyadic& d = circle.bend;
    const Dyadic k = valueAt(f, circle.origin) * d * d;
    const Vector<Dyadic> m = gradientAt(f, circle.origin);
    return {k * ee + d * dot(m, change) * ne - f.bend * ne * ne,
            Dyadic(2) * k * te + d * dot(m, tangent) * ne, k * tt};
  }
};

/// The real roots of a quadratic that is not zero everywhere.
std::vector<RootForm<Dyadic>> rootsOf(Quadratic<Dyadic> f) {
  const Dyadic zero(0);
  const int lead = f.a.sign() != 0 ? f.a.sign() : f.b.sign();
  if (lead > 0) f = {zero - f.a, zero - f.b, zero - f.c};
  if (lead == 0) return {};
  if (f.a.sign() == 0) return {{f.c, zero, zero, zero - f.b}};
  const Dyadic radicand = f.b * f.b - Dyadic(4) * f.a * f.c;
  if (radicand.sign() < 0) return {};
  const Dyadic d = Dyadic(-2) * f.a;
  return {{f.b, Dyadic(1), radicand, d}, {f.b, Dyadic(-1), radicand, d}};
}

/// The sign of f(root).
int signAt(const Quadratic<Dyadic>& f, const RootForm<Dyadic>& t) {
  return signWithRoot(
      f.a * (t.n * t.n + t.s * t.s * t.radicand) + f.b * t.n * t.d + f.c * t.d * t.d,
      (Dyadic(2) * f.a * t.n + f.b * t.d) * t.s, t.radicand);
}

bool areApart(const Box2& s, const Box2& t) {
  return s.high.x < t.low.x || t.high.x < s.low.x || s.high.y < t.low.y || t.high.y < s.low.y;
}

Box2 boxAround(Point2 centre, double radius) {
  return {{centre.x - radius, centre.y - radius}, {centre.x + radius, centre.y + radius}};
}

}  // namespace

DiscThrough circleOf(const Step& arc) {
  const LeftArc left = leftArcOf(arc);
  return {left.a, left.b, left.c};
}

HalfPlane chordOf(const Step& arc) {
  const LeftArc left = leftArcOf(arc);  // lies to the right of its chord
  return {left.c, left.c, left.a, true};
}

Disc roundedCircle(const DiscThrough& disc) {
  const Point2 u = disc.b - disc.a, s = disc.c - disc.a;
  const double uu = dot(u, u), ss = dot(s, s);
  const Point2 toCentre = (0.5 / cross(u, s)) * Point2{uu * s.y - ss * u.y, ss * u.x - uu * s.x};
  return {disc.a + toCentre, length(toCentre)};
}

double areaBesideChord(const Step& arc) {
  const Disc circle = roundedCircle(circleOf(arc));
  const Point2 p = arc.from - circle.centre, q = arc.to - circle.centre;
  const LeftArc left = leftArcOf(arc);
  double sweep = af2::angleOf({dot(p, q), cross(p, q)});
  if (!left.reversed && sweep < 0) sweep += 2 * M_PI;
  if (left.reversed && sweep > 0) sweep -= 2 * M_PI;
  return 0.5 * (circle.radius * circle.radius * sweep - cross(p, q));
}

Box2 boxOf(const Step& arc) {
  constexpr double kInflation = 1 + 1e-9;
  if (dot(arc.from - *arc.via, arc.to - *arc.via) <= 0)  // the arc is at most a half circle
    return boxAround(0.5 * (arc.from + arc.to), 0.5 * kInflation * distance(arc.from, arc.to));
  const Disc circle = roundedCircle(circleOf(arc));
  const Curve<Bounded> curve = curveOf<Bounded>(circleOf(arc));
  const double trust = curve.bend.value() / (curve.bend.error() + 1e-300);
  if (!(trust > 1e12) || !std::isfinite(circle.radius))
    return {{-kInfinity, -kInfinity}, {kInfinity, kInfinity}};
  return boxAround(circle.centre, kInflation * circle.radius);
}

bool arcsMeet(const Step& s, const Step& t, bool tFollows, bool sFollows) {
  if (areApart(boxOf(s), boxOf(t))) return false;
  const LeftArc arc = leftArcOf(s);
  const ParametricArc parametric(arc);
  const Quadratic<Dyadic> f = parametric.along(curveOf<Dyadic>(circleOf(t)));
  if (f.a.sign() == 0 && f.b.sign() == 0 && f.c.sign() == 0) return overlap(s, t);

  const Quadratic<Dyadic> beyondChord = parametric.along(curveOf<Dyadic>(chordOf(t)));
  const bool startIsShared = arc.reversed ? tFollows : sFollows;
  const bool endIsShared = arc.reversed ? sFollows : tFollows;
  for (const RootForm<Dyadic>& root : rootsOf(f)) {
    const int fromStart = signWithRoot(root.n, root.s, root.radicand);
    const int fromEnd = signWithRoot(root.n - root.d, root.s, root.radicand);
    if (fromStart < 0 || fromEnd > 0) continue;
    if ((startIsShared && fromStart == 0) || (endIsShared && fromEnd == 0)) continue;
    if (signAt(beyondChord, root) >= 0) return true;
  }
  return false;
}

}  // namespace af2::dsl::shapes
