// Laws of sets, on a lattice where corners, tangents, seams and slits coincide all the time.
#include <gtest/gtest.h>

#include <cmath>

#include "random_shapes.h"

namespace af2::dsl {
namespace {

using test::RandomShapes;

enum class Place { Out, On, In };

Place placeOf(const MadeZone& zone, Point2 p) {
  if (!zone.zone) return Place::Out;
  if (zone.zone->contains(p, ZoneBoundary::Ignored)) return Place::In;
  return zone.zone->contains(p, ZoneBoundary::Counts) ? Place::On : Place::Out;
}

bool meets(const MadeZone& zone, Point2 from, Point2 to) {
  return zone.zone && zone.zone->meets(from, to, ZoneBoundary::Ignored);
}

Shape bounded(const Shape& shape) {
  return shape & Shape::hull({{-6, -6}, {6, -6}, {6, 6}, {-6, 6}});
}

struct Law {
  const char* name;
  Shape left, right;
};

std::vector<Law> lawsOf(const Shape& a, const Shape& b, const Shape& c) {
  return {
      {"A | B = B | A", a | b, b | a},
      {"A & B = B & A", a & b, b & a},
      {"A | A & B = A", a | (a & b), a},
      {"A & (A | B) = A", a & (a | b), a},
      {"A & (B | C) = A & B | A & C", a & (b | c), (a & b) | (a & c)},
      {"A | (B & C) = (A | B) & (A | C)", a | (b & c), (a | b) & (a | c)},
      {"A - (B | C) = (A - B) - C", a - (b | c), (a - b) - c},
      {"A - (B & C) = A - B | A - C", a - (b & c), (a - b) | (a - c)},
      {"A - (A - B) = A & B", a - (a - b), a & b},
      {"A - B | A & B = A", (a - b) | (a & b), a},
      {"(A - B) & B is empty", (a - b) & b, b - b},
  };
}

TEST(Laws, HoldForEveryPointAndEdgeOfALattice) {
  SCOPED_TRACE(test::seedNote());
  RandomShapes random(test::seedOfRun() + 10);
  for (int i = 0; i < 60; ++i) {
    const Shape a = bounded(random.latticeShape(i % 2)), b = bounded(random.latticeShape(0));
    const Shape c = bounded(random.latticeShape(0));
    for (const Law& law : lawsOf(a, b, c)) {
      SCOPED_TRACE(law.name);
      const MadeZone left = makeZone(law.left), right = makeZone(law.right);
      for (int k = 0; k < 60; ++k) {
        const Point2 p = random.latticePoint(), q = random.latticePoint();
        ASSERT_EQ(placeOf(left, p), placeOf(right, p)) << i << ": " << p.x << ", " << p.y;
        ASSERT_EQ(meets(left, p, q), meets(right, p, q))
            << i << ": " << p.x << ", " << p.y << " -> " << q.x << ", " << q.y;
      }
    }
  }
}

TEST(Laws, AnEdgeMeetsTheSameZoneInBothDirections) {
  SCOPED_TRACE(test::seedNote());
  RandomShapes random(test::seedOfRun() + 11);
  for (int i = 0; i < 300; ++i) {
    const MadeZone zone = makeZone(bounded(random.latticeShape(2)));
    for (int k = 0; k < 40; ++k) {
      const Point2 p = random.latticePoint(), q = random.latticePoint();
      ASSERT_EQ(meets(zone, p, q), meets(zone, q, p));
      if (!zone.zone) continue;
      ASSERT_EQ(zone.zone->meets(p, q, ZoneBoundary::Counts),
                zone.zone->meets(q, p, ZoneBoundary::Counts));
    }
  }
}

TEST(Laws, PointsAndEdgesAgree) {
  SCOPED_TRACE(test::seedNote());
  RandomShapes random(test::seedOfRun() + 12);
  for (int i = 0; i < 300; ++i) {
    const MadeZone zone = makeZone(bounded(random.latticeShape(2)));
    if (!zone.zone) continue;
    for (int k = 0; k < 40; ++k) {
      const Point2 p = random.latticePoint(), q = random.latticePoint();
      const Point2 middle = 0.5 * (p + q);  // exact on the lattice
      for (const Point2 on : {p, middle, q}) {
        const Place place = placeOf(zone, on);
        ASSERT_TRUE(place != Place::In || meets(zone, p, q));
        ASSERT_TRUE(place == Place::Out || zone.zone->meets(p, q, ZoneBoundary::Counts));
      }
      ASSERT_TRUE(p != q || meets(zone, p, q) == (placeOf(zone, p) == Place::In));
      const bool halves = meets(zone, p, middle) || meets(zone, middle, q);
      ASSERT_EQ(meets(zone, p, q), halves);
    }
  }
}

/// The engine's fast form and the general one, on polygons whose corners, sides and diagonals the
/// lattice hits all the time.
TEST(Laws, AConvexPolygonAnswersLikeTheEnginesOwn) {
  SCOPED_TRACE(test::seedNote());
  RandomShapes random(test::seedOfRun() + 14);
  int tried = 0;
  while (tried < 200) {
    std::vector<Point2> corners;
    for (int k = random.integer(3, 6); k > 0; --k) corners.push_back(random.latticePoint());
    if (!ConvexPolygonZone::isConvex(corners)) continue;
    ++tried;
    const MadeZone list = makeZone(Shape::convex(corners)), hull = makeZone(Shape::hull(corners));
    const MadeZone inside = makeZone(Shape::convex(corners) & Shape::disc({0, 0}, 100));
    for (int k = 0; k < 60; ++k) {
      const Point2 p = random.latticePoint(), q = random.latticePoint();
      for (const auto* other : {&hull, &inside}) {
        ASSERT_EQ(placeOf(list, p), placeOf(*other, p));
        ASSERT_EQ(meets(list, p, q), meets(*other, p, q));
        ASSERT_EQ(list.zone->meets(p, q, ZoneBoundary::Counts),
                  other->zone->meets(p, q, ZoneBoundary::Counts));
      }
    }
  }
}

Point2 turned(Point2 p) { return {-p.y, p.x}; }

/// The shape turned by a right angle, which loses no bit.
Shape turned(const Shape& shape) {
  switch (shape.kind()) {
    case ShapeKind::Disc:
      return Shape::disc(turned(shape.points()[0]), shape.numbers()[0]);
    case ShapeKind::Left:
      return Shape::left(turned(shape.points()[0]), turned(shape.points()[1]));
    case ShapeKind::Union:
      return turned(shape.parts()[0]) | turned(shape.parts()[1]);
    case ShapeKind::Intersection:
      return turned(shape.parts()[0]) & turned(shape.parts()[1]);
    case ShapeKind::Difference:
      return turned(shape.parts()[0]) - turned(shape.parts()[1]);
    case ShapeKind::Hull: {
      std::vector<Point2> points;
      for (const Point2 p : shape.points()) points.push_back(turned(p));
      return Shape::hull(points);
    }
    case ShapeKind::Poly: {
      std::vector<PathStep> path;
      std::size_t next = 0;
      for (const bool isArc : shape.arcs()) {
        PathStep step;
        if (isArc) step.via = turned(shape.points()[next++]);
        step.to = turned(shape.points()[next++]);
        path.push_back(step);
      }
      return Shape::poly(path);
    }
    default:
      return Shape::disc({0, 0}, 0);  // sectors have rounded flanks; left out
  }
}

bool hasSector(const Shape& shape) {
  bool has = shape.kind() == ShapeKind::Sector;
  for (const Shape& part : shape.parts()) has = has || hasSector(part);
  return has;
}

TEST(Laws, AnswersTurnWithTheShape) {
  SCOPED_TRACE(test::seedNote());
  RandomShapes random(test::seedOfRun() + 13);
  for (int i = 0; i < 300; ++i) {
    const Shape shape = bounded(random.latticeShape(2));
    if (hasSector(shape)) continue;
    const MadeZone zone = makeZone(shape), other = makeZone(turned(shape));
    for (int k = 0; k < 40; ++k) {
      const Point2 p = random.latticePoint(), q = random.latticePoint();
      ASSERT_EQ(placeOf(zone, p), placeOf(other, turned(p)));
      ASSERT_EQ(meets(zone, p, q), meets(other, turned(p), turned(q)));
    }
  }
}

}  // namespace
}  // namespace af2::dsl
