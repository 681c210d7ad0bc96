#include "geometry/base/disjoint_sets.h"

#include <gtest/gtest.h>

namespace af2::geometry {
namespace {

TEST(DisjointSets, AreSinglesAtFirst) {
  DisjointSets sets(3);
  for (const std::uint32_t i : {0u, 1u, 2u}) EXPECT_EQ(sets.of(i), i);
}

TEST(DisjointSets, HaveTheirLowestMemberStandForThem) {
  DisjointSets sets(6);
  sets.join(5, 4);
  sets.join(4, 2);
  sets.join(3, 1);
  for (const std::uint32_t i : {2u, 4u, 5u}) EXPECT_EQ(sets.of(i), 2u);
  EXPECT_EQ(sets.of(3), 1u);
  sets.join(5, 3);
  for (const std::uint32_t i : {1u, 2u, 3u, 4u, 5u}) EXPECT_EQ(sets.of(i), 1u);
  EXPECT_EQ(sets.of(0), 0u);
}

TEST(DisjointSets, StayWhatTheyAreWhenJoinedWithThemselves) {
  DisjointSets sets(3);
  sets.join(1, 2);
  sets.join(2, 1);
  sets.join(0, 0);
  EXPECT_EQ(sets.of(2), 1u);
  EXPECT_EQ(sets.of(0), 0u);
}

}  // namespace
}  // namespace af2::geometry
