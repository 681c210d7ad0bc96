#include "geometry/mesh/element_scores.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/small_meshes.h"
#include "tests/support/triangle_rules.h"

namespace af2::geometry {
namespace {

/// The distance of the first side from length 1, so that it depends on the order of the corners.
class FirstSideMetric final : public AF2ElementMetric {
 public:
  std::optional<double> badness(std::span<const Point2> corners) const override {
    return std::abs(distance(corners[0], corners[1]) - 1);
  }
};

RuleSetDefinition rulesWith(std::shared_ptr<const AF2ElementMetric> metric) {
  RuleSetDefinition rules = testing::triangleSet()->definition();
  rules.metric = std::move(metric);
  return rules;
}

ModelMesh triangle(double size) {
  const double h = std::sqrt(3) / 2;
  ModelMesh mesh = oneElement({{0, 0, 5}, {1, 0, 5}, {0.5, h, 5}});
  mesh.wantedSizes.assign(3, size);
  return mesh;
}

TEST(ElementScores, AreZeroForTheIdealElementOfTheAskedSize) {
  const RuleSetDefinition rules = rulesWith(std::make_shared<ShapeSizeMetric>(10));
  EXPECT_NEAR(elementScores(triangle(1), rules, 1)[0], 0, 1e-6);
  EXPECT_NEAR(elementScores(triangle(2), rules, 1)[0], 3 * (0.5 + 2 - 2), 1e-6);
}

TEST(ElementScores, DoNotDependOnTheSizeWhereTheChartHasTheUnitOfTheBase) {
  RuleSetDefinition rules = rulesWith(std::make_shared<ShapeSizeMetric>(10));
  rules.unit = ChartUnit::BaseLength;
  EXPECT_NEAR(elementScores(triangle(2), rules, 1)[0], 0, 1e-6);
}

TEST(ElementScores, TakeTheBestRotationOfAChangedElement) {
  const RuleSetDefinition rules = rulesWith(std::make_shared<FirstSideMetric>());
  ModelMesh mesh = oneElement({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}});
  mesh.wantedSizes.assign(3, 1);
  EXPECT_FLOAT_EQ(elementScores(mesh, rules, 1)[0], 2);
  mesh.origins[0].isChanged = true;
  EXPECT_FLOAT_EQ(elementScores(mesh, rules, 1)[0], 0);
}

TEST(ElementScores, AreMissingWhereTheMetricHasNoValue) {
  const RuleSetDefinition rules = rulesWith(std::make_shared<ShapeSizeMetric>(10));
  ModelMesh mesh = oneElement({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  mesh.wantedSizes.assign(3, 1);
  EXPECT_TRUE(std::isnan(elementScores(mesh, rules, 1)[0]));
}

}  // namespace
}  // namespace af2::geometry
