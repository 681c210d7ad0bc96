// Triangle values: our own evaluation of 10 (sqrt(3)/36 perimeter^2/area - 1) + sum (1/l + l) - 6,
// the measure of Netgen's and MeshKit's triangle rules (libsrc/meshing/ruler2.cpp,
// src/algs/AdvFront/AF2DfltRuleAppVisitor.cpp).
#include "engine/rule/element_metric.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/base/error.h"

namespace af2 {
namespace {

std::optional<double> badness(const std::vector<Point2>& corners, double weight = 10) {
  return ShapeSizeMetric(weight).badness(corners);
}

struct ReferenceTriangle {
  double base, value;
};

class TriangleBadness : public ::testing::TestWithParam<ReferenceTriangle> {};

TEST_P(TriangleBadness, OfAnIsoscelesTriangleOfHeight866) {
  const auto [base, value] = GetParam();
  const auto actual = badness({{0, 0}, {base, 0}, {base / 2, .866}});
  ASSERT_TRUE(actual);
  EXPECT_NEAR(*actual, value, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(ElementMetric, TriangleBadness,
                         ::testing::Values(ReferenceTriangle{.25, 10.063134967530623},
                                           ReferenceTriangle{.5, 2.3053796264016597},
                                           ReferenceTriangle{.8, 0.23857866194466126},
                                           ReferenceTriangle{1, 4.194903979737319e-09},
                                           ReferenceTriangle{1.25, 0.2498183523788411},
                                           ReferenceTriangle{1.5, 0.8510914296795615},
                                           ReferenceTriangle{1.8, 1.8579323996318964},
                                           ReferenceTriangle{1.9, 2.243201713039843},
                                           ReferenceTriangle{2, 2.648333459816751},
                                           ReferenceTriangle{2.5, 4.904328483771453}));

TEST(ElementMetric, IsZeroForTheUnitEquilateralAndTheUnitSquare) {
  EXPECT_NEAR(*badness({{0, 0}, {1, 0}, {.5, std::sqrt(.75)}}), 0, 1e-13);
  EXPECT_NEAR(*badness({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), 0, 1e-13);
}

TEST(ElementMetric, GrowsWithTheSizeErrorOfASquare) {
  // Shape is perfect; four edges of length 2 cost 2 + 1/2 - 2 each.
  EXPECT_NEAR(*badness({{0, 0}, {2, 0}, {2, 2}, {0, 2}}), 4 * .5, 1e-13);
  EXPECT_NEAR(*badness({{0, 0}, {.5, 0}, {.5, .5}, {0, .5}}), 4 * .5, 1e-13);
}

TEST(ElementMetric, HoldsAQuadrilateralAgainstTheSquare) {
  // Perimeter 6, area 2: 36/2/16 = 1.125; two edges of length 2.
  EXPECT_NEAR(*badness({{0, 0}, {2, 0}, {2, 1}, {0, 1}}), 10 * .125 + 2 * .5, 1e-13);
  EXPECT_NEAR(*badness({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, 3), 3 * .125 + 2 * .5, 1e-13);
}

TEST(ElementMetric, DoesNotDependOnTheFirstCorner) {
  const std::vector<Point2> quad{{.25, .5}, {1.5, .25}, {1.25, 1.5}, {0, 1.75}};
  const double first = *badness(quad);
  EXPECT_NEAR(*badness({quad[1], quad[2], quad[3], quad[0]}), first, 1e-13);
  EXPECT_NEAR(*badness({quad[3], quad[0], quad[1], quad[2]}), first, 1e-13);
}

TEST(ElementMetric, HasNoValueForDegenerateAndInvertedElements) {
  EXPECT_FALSE(badness({{0, 0}, {1, 0}, {2, 0}}));
  EXPECT_FALSE(badness({{0, 0}, {.5, 1}, {1, 0}}));
  EXPECT_FALSE(badness({{0, 0}, {0, 0}, {1, 0}}));
  EXPECT_FALSE(badness({{0, 0}, {0, 1}, {1, 1}, {1, 0}}));
  EXPECT_FALSE(badness({{0, 0}, {1, 0}, {1, 0}, {0, 1}})) << "an edge of length zero";
}

TEST(ScoreBound, AcceptsWhatLiesBelowTheBoundOfTheLevel) {
  const ScoreBound bound({2, 4, 8});
  EXPECT_TRUE(bound.accepts(1.999, 1));
  EXPECT_FALSE(bound.accepts(2, 1));
  EXPECT_TRUE(bound.accepts(2, 2));
  EXPECT_FALSE(bound.accepts(8, 3));
}

TEST(ScoreBound, TheLastBoundHoldsForHigherLevels) {
  const ScoreBound bound({2, 4});
  EXPECT_TRUE(bound.accepts(3, 50));
  EXPECT_FALSE(bound.accepts(4, 50));
}

TEST(ScoreBound, NeedsABound) { EXPECT_THROW(ScoreBound({}), InputError); }

}  // namespace
}  // namespace af2
