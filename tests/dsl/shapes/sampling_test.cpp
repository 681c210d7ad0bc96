// Zones held against plain arithmetic at many points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "random_shapes.h"

namespace af2::dsl {
namespace {

using test::RandomShapes;

bool isLeftOf(Point2 p, Point2 from, Point2 to) { return cross(to - from, p - from) >= 0; }

double distanceToSegment(Point2 p, Point2 a, Point2 b) {
  const double size = dot(b - a, b - a);
  const double t = size > 0 ? std::clamp(dot(p - a, b - a) / size, 0.0, 1.0) : 0;
  return distance(p, a + t * (b - a));
}

/// The path of a Poly as a fine polygon.
std::vector<Point2> sampledPath(const Shape& poly) {
  std::vector<Point2> corners;
  Point2 from = poly.points().back();
  std::size_t next = 0;
  for (const bool isArc : poly.arcs()) {
    if (!isArc) {
      corners.push_back(from = poly.points()[next++]);
      continue;
    }
    const Point2 via = poly.points()[next++], to = poly.points()[next++];
    const Point2 u = via - from, s = to - from;
    const Point2 c = from + (0.5 / cross(u, s)) * Point2{dot(u, u) * s.y - dot(s, s) * u.y,
                                                         dot(s, s) * u.x - dot(u, u) * s.x};
    double sweep = std::atan2(cross(from - c, to - c), dot(from - c, to - c));
    const bool ccw = cross(u, s) > 0;
    if (ccw && sweep < 0) sweep += 2 * M_PI;
    if (!ccw && sweep > 0) sweep -= 2 * M_PI;
    constexpr int kCount = 4000;
    for (int i = 1; i <= kCount; ++i) {
      const double angle = sweep * i / kCount, co = std::cos(angle), si = std::sin(angle);
      const Point2 r = from - c;
      corners.push_back(c + Point2{co * r.x - si * r.y, si * r.x + co * r.y});
    }
    from = to;
  }
  return corners;
}

bool isInPolygon(Point2 p, const std::vector<Point2>& corners) {
  bool inside = false;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const Point2 a = corners[j], b = corners[i];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
      inside = !inside;
  }
  return inside;
}

bool isInHull(Point2 p, const std::vector<Point2>& points) {
  // In the hull iff in some triangle of the points.
  for (const Point2 a : points)
    for (const Point2 b : points)
      for (const Point2 c : points)
        if (cross(b - a, c - a) > 0 && isLeftOf(p, a, b) && isLeftOf(p, b, c) && isLeftOf(p, c, a))
          return true;
  return false;
}

bool isNearHull(Point2 p, const std::vector<Point2>& points, double d) {
  if (isInHull(p, points)) return true;
  for (const Point2 a : points)
    for (const Point2 b : points)
      if (distanceToSegment(p, a, b) <= d) return true;
  return false;
}

/// A set as a plain function of points.
class Reference {
 public:
  explicit Reference(const Shape& shape) : shape_(shape) {
    if (shape.kind() == ShapeKind::Poly) path_ = sampledPath(shape);
    for (const Shape& part : shape.parts()) parts_.emplace_back(part);
  }

  bool contains(Point2 p) const {
    const auto& points = shape_.points();
    const auto& numbers = shape_.numbers();
    switch (shape_.kind()) {
      case ShapeKind::Disc:
        return distance(p, points[0]) <= numbers[0];
      case ShapeKind::Left:
        return cross(points[1], p - points[0]) >= 0;
      case ShapeKind::Sector: {
        if (distance(p, points[0]) > numbers[0]) return false;
        double angle = std::atan2(p.y - points[0].y, p.x - points[0].x) - numbers[1];
        angle -= 2 * M_PI * std::floor(angle / (2 * M_PI));
        return angle <= numbers[2] - numbers[1];
      }
      case ShapeKind::Hull:
        return isInHull(p, points);
      case ShapeKind::Grow:
        return isNearHull(p, shape_.parts()[0].points(), numbers[0]);
      case ShapeKind::Poly:
        return isInPolygon(p, path_);
      case ShapeKind::Union:
        return parts_[0].contains(p) || parts_[1].contains(p);
      case ShapeKind::Intersection:
        return parts_[0].contains(p) && parts_[1].contains(p);
      case ShapeKind::Difference:
        return parts_[0].contains(p) && !parts_[1].contains(p);
      case ShapeKind::Convex:
      case ShapeKind::User:
        break;
    }
    return false;
  }

 private:
  const Shape& shape_;
  std::vector<Point2> path_;
  std::vector<Reference> parts_;
};

/// A random shape in general position that is a zone.
Shape randomZone(RandomShapes& random, int depth) {
  const Shape frame = Shape::hull({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
  return random.shape(depth) & frame;
}

TEST(Zones, ContainWhatPlainArithmeticPutsInside) {
  SCOPED_TRACE(test::seedNote());
  RandomShapes random(test::seedOfRun());
  int inside = 0, wrong = 0;
  for (int i = 0; i < 300; ++i) {
    const Shape shape = randomZone(random, i % 4);
    const MadeZone made = makeZone(shape);
    ASSERT_TRUE(made.zone) << made.reason;
    const Reference reference(shape);
    for (int k = 0; k < 100; ++k) {
      const Point2 p = random.point();
      const bool expected = reference.contains(p);
      inside += expected;
      wrong += made.zone->contains(p, ZoneBoundary::Counts) != expected;
      wrong += made.zone->contains(p, ZoneBoundary::Ignored) != expected;
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_EQ(wrong, 0);
}

TEST(Zones, AreMetByEdgesThatHaveAPointInside) {
  SCOPED_TRACE(test::seedNote());
  RandomShapes random(test::seedOfRun() + 1);
  int met = 0, thin = 0;
  for (int i = 0; i < 300; ++i) {
    const Shape shape = randomZone(random, i % 4);
    const MadeZone made = makeZone(shape);
    ASSERT_TRUE(made.zone) << made.reason;
    const Reference reference(shape);
    for (int k = 0; k < 20; ++k) {
      const Point2 from = random.point(), to = from + random.real(0.02, 0.5) * random.point();
      const auto holdsSample = [&](int count) {
        for (int s = 0; s <= count; ++s)
          if (reference.contains(from + (static_cast<double>(s) / count) * (to - from)))
            return true;
        return false;
      };
      const bool meets = made.zone->meets(from, to, ZoneBoundary::Ignored);
      met += meets;
      if (meets == holdsSample(100)) continue;
      ASSERT_TRUE(meets) << "a point of the edge is inside";
      if (!holdsSample(20000)) ++thin;  // only a sliver of the edge is inside
    }
  }
  EXPECT_GT(met, 300);
  EXPECT_LE(thin, 1);
}

TEST(Zones, LieInTheirBoxes) {
  SCOPED_TRACE(test::seedNote());
  RandomShapes random(test::seedOfRun() + 2);
  for (int i = 0; i < 200; ++i) {
    const MadeZone made = makeZone(random.shape(i % 4) & Shape::disc({0, 0}, 4));
    ASSERT_TRUE(made.zone) << made.reason;
    const Box2 box = made.zone->boundingBox();
    for (int k = 0; k < 50; ++k) {
      const Point2 p = 2 * random.point();
      if (p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y) continue;
      EXPECT_FALSE(made.zone->contains(p, ZoneBoundary::Counts));
    }
  }
}

TEST(Grow, HoldsWhatIsCloseToACombination) {
  SCOPED_TRACE(test::seedNote());
  RandomShapes random(test::seedOfRun() + 3);
  for (int i = 0; i < 40; ++i) {
    const Shape inner = (random.shape(0) - random.shape(0)) & Shape::disc({0, 0}, 3);
    const double d = random.real(0.05, 0.4);
    const MadeZone zone = makeZone(inner), grown = makeZone(Shape::grow(inner, d));
    ASSERT_TRUE(grown.zone) << grown.reason;
    for (int k = 0; k < 100; ++k) {
      const Point2 p = 1.5 * random.point();
      bool isNear = false, isWellApart = true;
      for (int a = 0; a < 720; ++a)
        for (const double r : {0.0, 0.25, 0.5, 0.75, 0.98, 1.02}) {
          const Point2 q = p + r * d * Point2{std::cos(a * M_PI / 360), std::sin(a * M_PI / 360)};
          if (!zone.zone->contains(q, ZoneBoundary::Counts)) continue;
          isWellApart = false;
          isNear = isNear || r < 1;
        }
      EXPECT_TRUE(!isNear || grown.zone->contains(p, ZoneBoundary::Counts));
      // Slivers thinner than the samples may be missed, but hardly ever.
      if (isWellApart && grown.zone->contains(p, ZoneBoundary::Counts)) {
        const MadeZone less = makeZone(Shape::grow(inner, 0.96 * d));
        EXPECT_FALSE(less.zone->contains(p, ZoneBoundary::Counts)) << i << ' ' << p.x << ' ' << p.y;
      }
    }
  }
}

}  // namespace
}  // namespace af2::dsl
