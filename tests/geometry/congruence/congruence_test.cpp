#include "geometry/congruence/congruence.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/geometry/congruence/motions.h"

namespace af2::geometry {
namespace {

using testing::kAway, testing::kMirror;
using Places = std::vector<Point3>;

/// In the plane z = 0, seen from above.
const Places kHook = {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};

/// Loops with vertices numbered in their order.
FrontInput boundaryOf(const std::vector<Places>& loops, const Point3& normal = {0, 0, 1}) {
  FrontInput input;
  for (const Places& places : loops) {
    auto& loop = input.loops.emplace_back();
    for (const Point3& place : places)
      loop.push_back({VertexId(input.vertexCount++), {place, normal, 0, 0}});
  }
  return input;
}

Places moved(Places places, const Motion& motion) {
  for (Point3& place : places) place = motion.moved(place);
  return places;
}

Places beginningAt(std::size_t first, Places places) {
  std::ranges::rotate(places, places.begin() + static_cast<std::ptrdiff_t>(first));
  return places;
}

Places backwards(Places places) {
  std::ranges::reverse(places);
  return places;
}

std::optional<Congruence> congruence(const FrontInput& one, const FrontInput& other) {
  return congruenceOf(formOf(one), formOf(other));
}

/// Each vertex lies where the motion moves it.
void expectMatched(const FrontInput& one, const FrontInput& other, const Congruence& found) {
  Places places(other.vertexCount);
  for (const auto& loop : other.loops)
    for (const BoundaryCorner& corner : loop) places[corner.vertex.value] = corner.point.position;
  for (const auto& loop : one.loops)
    for (const BoundaryCorner& corner : loop)
      EXPECT_LT(distance(found.motion.moved(corner.point.position),
                         places[found.vertices[corner.vertex.value].value]),
                1e-12);
}

TEST(Congruence, IsFoundWhereverLoopsBegin) {
  const FrontInput one = boundaryOf({kHook});
  for (std::size_t first = 0; first < kHook.size(); ++first) {
    const FrontInput other =
        boundaryOf({beginningAt(first, moved(kHook, kAway))}, kAway.turned({0, 0, 1}));
    const auto found = congruence(one, other);
    ASSERT_TRUE(found) << first;
    EXPECT_FALSE(found->isReflection);
    expectMatched(one, other, *found);
  }
}

TEST(Congruence, MirrorsLoopsThatRunTheOtherWay) {
  const FrontInput one = boundaryOf({kHook});
  for (std::size_t first = 0; first < kHook.size(); ++first) {
    const FrontInput other = boundaryOf({beginningAt(first, backwards(moved(kHook, kMirror)))});
    const auto found = congruence(one, other);
    ASSERT_TRUE(found) << first;
    EXPECT_TRUE(found->isReflection);
    expectMatched(one, other, *found);
  }
}

TEST(Congruence, PrefersMotionsWithoutReflection) {
  const Places square = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const auto found = congruence(boundaryOf({square}), boundaryOf({square}));
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->isReflection);
  EXPECT_EQ(found->vertices[0], VertexId(0));
}

TEST(Congruence, NeedsEachCornerInItsPlace) {
  Places other = moved(kHook, kAway);
  other[3].x += 1e-6;
  EXPECT_FALSE(congruence(boundaryOf({kHook}), boundaryOf({other}, kAway.turned({0, 0, 1}))));
  EXPECT_FALSE(congruence(boundaryOf({kHook}), boundaryOf({backwards(kHook)})));
}

TEST(Congruence, NeedsTheSameSideOfTheSurface) {
  EXPECT_FALSE(congruence(boundaryOf({kHook}), boundaryOf({kHook}, {0, 0, -1})));
  EXPECT_FALSE(congruence(boundaryOf({kHook}), boundaryOf({kHook}, {0, 0.6, 0.8})));
}

TEST(Congruence, MatchesHolesInAnyOrder) {
  const Places small = {{0.2, 0.2, 0}, {0.2, 0.4, 0}, {0.5, 0.2, 0}};
  const Places large = {{1.2, 0.2, 0}, {1.2, 0.8, 0}, {2.5, 0.2, 0}};
  const FrontInput one = boundaryOf({kHook, small, large});
  const Point3 normal = kAway.turned({0, 0, 1});
  const FrontInput other = boundaryOf(
      {moved(large, kAway), moved(kHook, kAway), beginningAt(1, moved(small, kAway))}, normal);
  const auto found = congruence(one, other);
  ASSERT_TRUE(found);
  expectMatched(one, other, *found);

  Places shifted = moved(small, kAway);
  for (Point3& place : shifted) place = place + kAway.turned({0.01, 0, 0});
  EXPECT_FALSE(
      congruence(one, boundaryOf({moved(large, kAway), moved(kHook, kAway), shifted}, normal)));
}

TEST(Congruence, KeepsVerticesThatAreSeveralCorners) {
  FrontInput one = boundaryOf({kHook}), other = one;
  one.loops[0][4].vertex = one.loops[0][1].vertex;
  EXPECT_FALSE(congruence(one, other));
  other.loops[0][4].vertex = other.loops[0][1].vertex;
  EXPECT_TRUE(congruence(one, other));
}

TEST(Congruence, IsNotKnownOnALineOrWithIsolatedVertices) {
  const FrontInput line = boundaryOf({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}});
  EXPECT_FALSE(congruence(line, line));
  FrontInput isolated = boundaryOf({kHook});
  isolated.isolated.push_back({VertexId(isolated.vertexCount++), {{0.5, 0.5, 0}, {0, 0, 1}, 0, 0}});
  EXPECT_FALSE(congruence(isolated, isolated));
  EXPECT_FALSE(congruence(FrontInput(), FrontInput()));
}

}  // namespace
}  // namespace af2::geometry
