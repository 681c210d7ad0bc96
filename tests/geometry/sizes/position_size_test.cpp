#include "geometry/sizes/position_size.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <span>

#include "engine/base/error.h"

namespace af2::geometry {
namespace {

/// Knows a cheaper way to reduce sizes, which it counts.
struct Cheap {
  int* lowered;

  void operator()(std::span<const Point3> at, std::span<double> sizes) const {
    for (std::size_t i = 0; i < at.size(); ++i) sizes[i] = at[i].x;
  }
  void lower(std::span<const Point3> at, std::span<double> sizes) const {
    ++*lowered;
    for (std::size_t i = 0; i < at.size(); ++i) sizes[i] = std::min(sizes[i], at[i].x);
  }
};

constexpr std::array<Point3, 3> kPlaces{Point3{1, 0, 0}, Point3{2, 0, 0}, Point3{3, 0, 0}};

TEST(PositionSize, ReducesSizesToThoseOfAFunction) {
  const PositionSize size([](const Point3& p) { return p.x; });
  std::array<double, 3> sizes{2, 2, 2};
  size.lower(kPlaces, sizes);
  EXPECT_EQ(sizes, (std::array<double, 3>{1, 2, 2}));
  double one = 5;
  size.lower({&kPlaces[2], 1}, {&one, 1});
  EXPECT_EQ(one, 3);
}

TEST(PositionSize, LetsAFunctionReduceSizesInItsOwnWay) {
  int lowered = 0;
  const PositionSize size(Cheap{&lowered});
  std::array<double, 3> sizes{2, 2, 2};
  size.lower(kPlaces, sizes);
  EXPECT_EQ(sizes, (std::array<double, 3>{1, 2, 2}));
  EXPECT_EQ(lowered, 1);
  EXPECT_EQ(size.at(kPlaces[1]), 2);
}

TEST(PositionSize, RefusesSizesThatAreNotPositiveAlsoWhereTheyReduce) {
  const PositionSize size([](const Point3& p) { return p.x - 2; });
  std::array<double, 3> sizes{2, 2, 2};
  EXPECT_THROW(size.lower(kPlaces, sizes), InputError);
}

TEST(PositionSize, IsSmallerOfTwoAndKnowsWhatWasAdded) {
  const PositionSize asked([](const Point3& p) { return 1 + p.x; });
  const PositionSize less([](const Point3&) { return 2.5; });
  const PositionSize both = PositionSize::smallerOf(asked, less);
  for (const Point3& place : kPlaces)
    EXPECT_EQ(both.at(place), std::min(asked.at(place), less.at(place)));
  EXPECT_TRUE(both.below(asked).isSameAs(less));
  EXPECT_TRUE(both.below(less).isSameAs(both)) << "nothing is known about it";
  EXPECT_TRUE(asked.below(asked).isSameAs(asked));
  EXPECT_TRUE(PositionSize::smallerOf({}, less).isSameAs(less));
  EXPECT_FALSE(PositionSize(asked).isSameAs(less));
}

}  // namespace
}  // namespace af2::geometry
