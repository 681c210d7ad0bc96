#include "engine/base/predicates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace af2 {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

Turn reversed(Turn t) { return static_cast<Turn>(-static_cast<int>(t)); }

TEST(Orientation, TellsLeftFromRightFromStraight) {
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {0, 1}), Turn::Left);
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {0, -1}), Turn::Right);
  EXPECT_EQ(orientation({0, 0}, {1, 0}, {7, 0}), Turn::Straight);
  EXPECT_EQ(orientation({0, 0}, {3, 3}, {1, 1}), Turn::Straight);
}

TEST(Orientation, IsStraightWhereTwoPointsCoincide) {
  EXPECT_EQ(orientation({.1, .2}, {.1, .2}, {5, 7}), Turn::Straight);
  EXPECT_EQ(orientation({5, 7}, {.1, .2}, {.1, .2}), Turn::Straight);
  EXPECT_EQ(orientation({.1, .2}, {5, 7}, {.1, .2}), Turn::Straight);
}

TEST(Orientation, SeesTheLastBitWhereRoundedArithmeticDoesNot) {
  // The classical example: a line through (12, 12) and (24, 24), points around (0.5, 0.5).
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const Point2 p{0.5 + i * kEps / 2, 0.5 + j * kEps / 2};
      const Turn expected = j > i ? Turn::Left : j < i ? Turn::Right : Turn::Straight;
      ASSERT_EQ(orientation({12, 12}, {24, 24}, p), expected) << i << " " << j;
      ASSERT_EQ(orientation(p, {12, 12}, {24, 24}), expected) << i << " " << j;
    }
  }
}

TEST(Orientation, IsAntisymmetricAndInvariantUnderRotationOfItsArguments) {
  std::mt19937 random(4711);
  std::uniform_int_distribution<int> small(-3, 3);
  for (int n = 0; n < 20000; ++n) {
    const auto point = [&] {
      return Point2{0.1 * small(random) + small(random) * 1e-17, 0.1 * small(random)};
    };
    const Point2 a = point(), b = point(), c = point();
    const Turn turn = orientation(a, b, c);
    ASSERT_EQ(orientation(b, c, a), turn);
    ASSERT_EQ(orientation(c, a, b), turn);
    ASSERT_EQ(orientation(b, a, c), reversed(turn));
    ASSERT_EQ(orientation(a, c, b), reversed(turn));
  }
}

TEST(Orientation, HoldsForTinyAndHugeCoordinates) {
  for (double s : {1e-160, 1e-100, 1e-14, 1.0, 1e40, 1e140}) {
    EXPECT_EQ(orientation({0, 0}, {s, 0}, {s / 2, s}), Turn::Left) << s;
    EXPECT_EQ(orientation({0, 0}, {s / 2, s}, {s, 0}), Turn::Right) << s;
    EXPECT_EQ(orientation({0, 0}, {s, s}, {2 * s, 2 * s}), Turn::Straight) << s;
  }
}

TEST(Orientation, HoldsFarFromTheOrigin) {
  const double far = 1e6;
  EXPECT_EQ(orientation({far, far}, {far + 1, far + 1}, {far + 2, far + 2}), Turn::Straight);
  EXPECT_EQ(orientation({far, far}, {far + 1, far + 1}, {far + 2, std::nextafter(far + 2, 1e9)}),
            Turn::Left);
}

TEST(SegmentsMeet, AtACrossingAndAtATouch) {
  EXPECT_TRUE(segmentsMeet({0, 0}, {2, 2}, {0, 2}, {2, 0}));
  EXPECT_TRUE(segmentsMeet({0, 0}, {2, 0}, {1, 0}, {1, 1})) << "an end on the other segment";
  EXPECT_TRUE(segmentsMeet({0, 0}, {1, 0}, {1, 0}, {2, 5})) << "a common end";
  EXPECT_TRUE(segmentsMeet({0, 0}, {2, 0}, {1, 0}, {3, 0})) << "an overlap";
  EXPECT_TRUE(segmentsMeet({0, 0}, {3, 0}, {1, 0}, {2, 0})) << "one within the other";
}

TEST(SegmentsMeet, NotWhenApart) {
  EXPECT_FALSE(segmentsMeet({0, 0}, {1, 0}, {2, 0}, {3, 0})) << "in line, apart";
  EXPECT_FALSE(segmentsMeet({0, 0}, {1, 0}, {0, 1}, {1, 1})) << "parallel";
  EXPECT_FALSE(segmentsMeet({0, 0}, {1, 1}, {2, 0}, {3, 5}));
  EXPECT_FALSE(segmentsMeet({0, 0}, {1, 0}, {1 + kEps, 0}, {2, 1})) << "apart by the last bit";
}

TEST(SegmentsMeet, TreatsASegmentOfLengthZeroAsAPoint) {
  EXPECT_TRUE(segmentsMeet({1, 1}, {1, 1}, {0, 0}, {2, 2}));
  EXPECT_FALSE(segmentsMeet({1, 1}, {1, 1}, {0, 0}, {2, 2.1}));
  EXPECT_TRUE(segmentsMeet({0, 0}, {2, 2}, {1, 1}, {1, 1}));
  EXPECT_FALSE(segmentsMeet({0, 0}, {2, 2}, {3, 3}, {3, 3}));
  EXPECT_TRUE(segmentsMeet({1, 1}, {1, 1}, {1, 1}, {1, 1}));
  EXPECT_FALSE(segmentsMeet({1, 1}, {1, 1}, {1, 2}, {1, 2}));
}

TEST(SegmentsMeet, DoesNotDependOnTheOrderOfItsArguments) {
  std::mt19937 random(99);
  std::uniform_int_distribution<int> grid(0, 4);
  for (int n = 0; n < 20000; ++n) {
    const auto point = [&] {
      return Point2{static_cast<double>(grid(random)), static_cast<double>(grid(random))};
    };
    const Point2 p = point(), q = point(), r = point(), s = point();
    const bool meet = segmentsMeet(p, q, r, s);
    ASSERT_EQ(segmentsMeet(q, p, r, s), meet);
    ASSERT_EQ(segmentsMeet(p, q, s, r), meet);
    ASSERT_EQ(segmentsMeet(r, s, p, q), meet);
  }
}

}  // namespace
}  // namespace af2
