#include "engine/mesh/vertex_stars.h"

#include <gtest/gtest.h>

#include "tests/support/element.h"

namespace af2 {
namespace {

/// Triangles around vertex 0, whose other corners are 1 to n; the last may be left out.
std::vector<Element> fan(std::size_t n, bool isClosed = true) {
  std::vector<Element> elements;
  for (std::size_t i = 1; i < n + isClosed; ++i)
    elements.push_back(testing::elementOf({0, i, i % n + 1}));
  return elements;
}

VertexStars starsOf(const std::vector<Element>& elements) {
  VertexStars stars(0, 40);
  for (const Element& element : elements) stars.add(element);
  stars.finish();
  return stars;
}

bool areAround(const std::vector<Element>& elements) { return starsOf(elements).areAround(0); }

// Some vertices have so many elements that they do not fit beside those of others.
constexpr std::size_t kMany = 30;

TEST(VertexStars, KnowWhatLiesAroundAVertex) {
  for (std::size_t n = 3; n <= kMany; ++n) {
    EXPECT_TRUE(areAround(fan(n))) << n;
    EXPECT_FALSE(areAround(fan(n, false))) << n;
  }
  EXPECT_FALSE(areAround({}));
  EXPECT_TRUE(areAround({{{VertexId(0), VertexId(1), VertexId(2), VertexId(3)}},
                         {{VertexId(0), VertexId(3), VertexId(4), VertexId(1)}}}));
}

TEST(VertexStars, FindAnEdgeThatIsUsedTwice) {
  for (std::size_t n = 3; n <= kMany; ++n) {
    std::vector<Element> elements = fan(n);
    elements.push_back(testing::elementOf({0, 1, 2}));
    EXPECT_FALSE(areAround(elements)) << n;  // the same once more
    elements.push_back(testing::elementOf({0, 2, 1}));
    EXPECT_FALSE(areAround(elements)) << n;  // and back: each edge leaves as often as it arrives
  }
}

TEST(VertexStars, FindAnElementThatIsTurnedAround) {
  for (std::size_t n = 3; n <= kMany; ++n) {
    std::vector<Element> elements = fan(n);
    elements.back() = testing::elementOf({0, 1, n});
    EXPECT_FALSE(areAround(elements)) << n;
  }
}

TEST(VertexStars, KeepTheOrderOfElements) {
  for (const std::size_t n : {5u, 8u, 9u, 30u}) {
    std::vector<VertexStars::Corner> corners;
    starsOf(fan(n)).corners(0, corners);
    ASSERT_EQ(corners.size(), n);
    for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(corners[i].next, i + 1);
  }
}

TEST(VertexStars, HoldOnlyTheVerticesTheyAreOf) {
  VertexStars stars(2, 4);
  for (const Element& element : fan(5)) stars.add(element);
  stars.finish();
  std::vector<VertexStars::Corner> corners;
  stars.corners(2, corners);
  EXPECT_EQ(corners.size(), 2u);
  EXPECT_FALSE(stars.isEmpty(3));
  EXPECT_TRUE(VertexStars(2, 4).isEmpty(3));
}

}  // namespace
}  // namespace af2
