// Discs held against rational arithmetic, at points and edges that touch up to rounding.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "dsl/shapes/shape.h"
#include "random_shapes.h"

namespace af2::dsl {
namespace {

using Rational = boost::multiprecision::cpp_rational;

/// The smallest squared distance of an edge from a centre.
Rational squaredDistance(Point2 centre, Point2 from, Point2 to) {
  const Rational wx = Rational(to.x) - Rational(from.x), wy = Rational(to.y) - Rational(from.y);
  const Rational px = Rational(from.x) - Rational(centre.x);
  const Rational py = Rational(from.y) - Rational(centre.y);
  const Rational size = wx * wx + wy * wy;
  Rational t = size == 0 ? Rational(0) : Rational(-(px * wx + py * wy) / size);
  if (t < 0) t = 0;
  if (t > 1) t = 1;
  const Rational x = px + t * wx, y = py + t * wy;
  return x * x + y * y;
}

TEST(DiscZone, AgreesWithRationalArithmeticWhereRoundingDecides) {
  SCOPED_TRACE(test::seedNote());
  test::RandomShapes random(test::seedOfRun() + 30);
  int entering = 0, apart = 0;
  for (int i = 0; i < 2000; ++i) {
    const Point2 centre = random.point();
    const double radius = random.real(0.1, 1.5), angle = random.real(0, 2 * M_PI);
    const Point2 out{std::cos(angle), std::sin(angle)}, along{-out.y, out.x};
    const Point2 rim = centre + radius * out;
    const Point2 from = rim + random.real(-1, 0.1) * along, to = rim + random.real(-0.1, 1) * along;
    const auto zone = makeZone(Shape::disc(centre, radius)).zone;
    const Rational square = Rational(radius) * Rational(radius);
    const Rational nearest = squaredDistance(centre, from, to);
    ASSERT_EQ(zone->meets(from, to, ZoneBoundary::Ignored), nearest < square);
    ASSERT_EQ(zone->meets(from, to, ZoneBoundary::Counts), nearest <= square);
    const Rational ofRim = squaredDistance(centre, rim, rim);
    ASSERT_EQ(zone->contains(rim, ZoneBoundary::Ignored), ofRim < square);
    ASSERT_EQ(zone->contains(rim, ZoneBoundary::Counts), ofRim <= square);
    (nearest < square ? entering : apart) += 1;
  }
  EXPECT_GT(entering, 300);  // rounding goes both ways
  EXPECT_GT(apart, 300);
}

/// Of two discs that touch up to rounding, an edge through both.
TEST(UnionOfDiscs, AgreesWithItsParts) {
  SCOPED_TRACE(test::seedNote());
  test::RandomShapes random(test::seedOfRun() + 31);
  for (int i = 0; i < 1000; ++i) {
    const Point2 p = random.point();
    const double r = random.real(0.1, 1), s = random.real(0.1, 1), angle = random.real(0, 6.28);
    const Point2 towards{std::cos(angle), std::sin(angle)};
    const Shape first = Shape::disc(p, r), second = Shape::disc(p + (r + s) * towards, s);
    const Point2 between = p + r * towards, aside{-towards.y, towards.x};
    const Point2 from = between - 0.5 * aside, to = between + 0.5 * aside;
    const auto enters = [&](const Shape& shape) {
      return makeZone(shape).zone->meets(from, to, ZoneBoundary::Ignored);
    };
    ASSERT_EQ(enters(first | second), enters(first) || enters(second));
    ASSERT_EQ(enters(first - second) || enters(first & second), enters(first));
  }
}

}  // namespace
}  // namespace af2::dsl
