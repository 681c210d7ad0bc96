#include "dsl/shapes/exact.h"

#include <gtest/gtest.h>

#include "dsl/shapes/crossing.h"

namespace af2::dsl::shapes {
namespace {

TEST(Dyadic, LosesNoBit) {
  const Dyadic big(1e300), small(1e-300);
  EXPECT_EQ(((big + small) - big - small).sign(), 0);
  EXPECT_EQ((big + small - big).sign(), 1);
  EXPECT_EQ((Dyadic(0.1) * Dyadic(3) - Dyadic(0.3)).sign(),
            1);  // 0.1 is a little more than it says
  EXPECT_EQ((Dyadic(0) - Dyadic(2.5)).sign(), -1);
}

TEST(Bounded, ProvesOnlyWhatItMay) {
  EXPECT_TRUE((Bounded(3) - Bounded(1)).isProven());
  EXPECT_TRUE((Bounded(0.1) - Bounded(0.1)).isProven());
  EXPECT_FALSE((Bounded(0.1) * Bounded(3) - Bounded(0.3)).isProven());
}

TEST(SignWithRoot, ComparesSquares) {
  EXPECT_EQ(signWithRoot(Dyadic(-3), Dyadic(2), Dyadic(2)), -1);  // 2 sqrt 2 < 3
  EXPECT_EQ(signWithRoot(Dyadic(-2), Dyadic(1), Dyadic(4)), 0);
  EXPECT_EQ(signWithRoot(Dyadic(2), Dyadic(-1), Dyadic(3)), 1);
  EXPECT_EQ(signWithRoot(Dyadic(0), Dyadic(-1), Dyadic(3)), -1);
}

TEST(Crossing, IsComparedExactlyWithOtherCrossings) {
  const Edge edge{{-10, 3}, {10, 3}};
  const auto large = Crossing::withCircle(edge, Disc{{0, 0}, 5});       // x = -4 and 4
  const auto other = Crossing::withCircle(edge, Disc{{3, 3}, 1});       // x = 2 and 4
  const auto irrational = Crossing::withCircle(edge, Disc{{0, 2}, 2});  // x = +-sqrt 3
  const auto same = Crossing::withCircle(edge, Disc{{0, 4}, 2});        // the same
  ASSERT_TRUE(large && other && irrational && same);
  EXPECT_EQ(large->second.compare(other->second, edge), 0);
  EXPECT_EQ(large->first.compare(other->first, edge), -1);
  EXPECT_EQ(irrational->second.compare(same->second, edge), 0);
  EXPECT_EQ(irrational->second.compare(other->first, edge), -1);
  EXPECT_EQ(large->second.compare(Crossing::atPoint(edge, {4, 3}), edge), 0);
  EXPECT_NEAR(irrational->second.approximate(), (10 + std::sqrt(3)) / 20, 1e-15);
}

TEST(Crossing, DoesNotMissACircleByRounding) {
  const Edge edge{{-10, 5}, {10, 5}};
  EXPECT_TRUE(Crossing::withCircle(edge, Disc{{0, 0}, 5}));
  EXPECT_FALSE(Crossing::withCircle(edge, Disc{{0, 0}, std::nextafter(5.0, 4.0)}));
}

}  // namespace
}  // namespace af2::dsl::shapes
