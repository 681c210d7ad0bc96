#include "dsl/netgen/rls_expression.h"

#include <gtest/gtest.h>

namespace af2::dsl {
namespace {

/// Four matched points; in each row weights of x or y of b, c, d, and a constant.
struct Row {
  Exact b, c, d, constant;
};

ExactMap map(const Row& x, const Row& y) {
  ExactMap map;
  map.constant = {x.constant, y.constant};
  map.weights[0] = {0, 0, x.b, 0, x.c, 0, x.d, 0};
  map.weights[1] = {0, 0, 0, 0, 0, y.c, 0, y.d};
  return map;
}

ExactMap sum(Exact b, Exact c, Exact d, Exact x = 0, Exact y = 0) {
  return map({b, c, d, x}, {b, c, d, y});
}

std::string written(const ExactMap& map) {
  const std::vector<NamedPoint> points{
      {"a", sum(0, 0, 0)}, {"b", sum(1, 0, 0)}, {"c", sum(0, 1, 0)}, {"d", sum(0, 0, 1)}};
  return pointExpression(map, points);
}

TEST(PointExpression, NamesAPoint) { EXPECT_EQ(written(sum(0, 1, 0)), "c"); }

TEST(PointExpression, FindsMiddlesAndCentroids) {
  EXPECT_EQ(written(sum(Exact(1, 2), 0, Exact(1, 2))), "mid(b, d)");
  EXPECT_EQ(written(sum(Exact(1, 4), Exact(1, 4), Exact(1, 4))), "centroid(a, b, c, d)");
  EXPECT_EQ(written(sum(Exact(1, 3), Exact(1, 3), 0)), "centroid(a, b, c)");
}

TEST(PointExpression, FindsParallelogramsAndReflections) {
  EXPECT_EQ(written(sum(-1, 1, 0)), "a + (c - b)");
  EXPECT_EQ(written(sum(0, 2, -1)), "2*c - d");
}

TEST(PointExpression, FindsPointsOnLines) {
  EXPECT_EQ(written(sum(0, Exact(3, 10), Exact(7, 10))), "lerp(c, d, 0.7)");
  EXPECT_EQ(written(sum(Exact(-1, 10), Exact(6, 10), Exact(6, 10))),
            "lerp(mid(a, b), mid(c, d), 1.2)");
  EXPECT_EQ(written(sum(Exact(-1, 2), Exact(3, 8), Exact(9, 8))), "lerp(b, lerp(c, d, 0.75), 1.5)");
}

TEST(PointExpression, SumsUpWhatHasNoName) {
  EXPECT_EQ(written(sum(Exact(11, 100), Exact(-23, 100), Exact(47, 100))),
            "a + 0.11*(b - a) - 0.23*(c - a) + 0.47*(d - a)");
}

TEST(PointExpression, PutsConstantsBehind) {
  EXPECT_EQ(written(sum(Exact(1, 2), 0, 0, 0, Exact(433, 500))), "mid(a, b) + (0, 0.866)");
}

TEST(PointExpression, KeepsCoordinatesApartThatAreMadeDifferently) {
  EXPECT_EQ(written(map({0, 0, 0, Exact(-1, 2)}, {0, Exact(3, 2), 0, 0})), "a + (-0.5, 1.5*c.y)");
  EXPECT_EQ(written(map({1, -1, 0, 0}, {0, 1, 0, 0})), "a + (b.x - c.x, c.y)");
}

TEST(PointExpression, TwiceMirroredIsItself) {
  const ExactMap skew = map({Exact(1, 7), 2, -1, Exact(1, 3)}, {0, Exact(3, 2), 5, 1});
  EXPECT_EQ(mirrored(mirrored(skew)), skew);
}

TEST(NumberText, IsExact) {
  EXPECT_EQ(numberText(Exact(433, 500)), "0.866");
  EXPECT_EQ(numberText(Exact(-1, 8)), "-0.125");
  EXPECT_EQ(numberText(Exact(30)), "30");
  EXPECT_EQ(numberText(Exact(5, 12)), "(5/12)");
}

}  // namespace
}  // namespace af2::dsl
