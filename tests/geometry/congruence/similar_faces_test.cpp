#include "geometry/congruence/similar_faces.h"

#include <gtest/gtest.h>

namespace af2::geometry {
namespace {

using Groups = std::vector<std::vector<std::size_t>>;

TEST(SimilarFaces, HaveTheSameTypeSegmentsAndArea) {
  EXPECT_EQ(similarFaces({{0, "plane", {2, 3}, 5},
                          {1, "plane", {2, 4}, 5},
                          {2, "cylinder", {2, 3}, 5},
                          {3, "plane", {2, 3}, 5.1},
                          {4, "plane", {2, 3}, 5 - 1e-9},
                          {5, "plane", {2, 3}, 5}}),
            (Groups{{0, 4, 5}, {1}, {2}, {3}}));
}

TEST(SimilarFaces, AreNoneOfUnknownArea) {
  EXPECT_EQ(similarFaces({{0, "plane", {2}, 0}, {1, "plane", {2}, 0}}), (Groups{{0}, {1}}));
  EXPECT_EQ(similarFaces({}), Groups{});
}

TEST(SimilarFaces, AreNotChained) {
  const double step = 0.7e-7;
  EXPECT_EQ(similarFaces(
                {{0, "plane", {}, 1}, {1, "plane", {}, 1 + step}, {2, "plane", {}, 1 + 2 * step}}),
            (Groups{{0, 1}, {2}}));
}

}  // namespace
}  // namespace af2::geometry
