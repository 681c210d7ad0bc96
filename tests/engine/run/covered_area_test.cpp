#include "engine/run/covered_area.h"

#include <gtest/gtest.h>

#include "tests/support/element.h"

namespace af2 {
namespace {

/// A unit square, in a plane that leans.
Mesh leaningSquare() {
  Mesh mesh;
  for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}})
    mesh.vertices.push_back({{1.0 * x, 0.6 * y, 0.8 * y}, {0, -0.8, 0.6}, 0, 0});
  return mesh;
}

TEST(CoveredArea, IsThatOfTrianglesAndQuadrilateralsInWholeUnits) {
  Mesh mesh = leaningSquare();
  CoveredArea covered(0.1);
  EXPECT_EQ(covered.of(mesh), 0u);
  mesh.elements.push_back(testing::elementOf({0, 1, 2}));
  EXPECT_EQ(covered.of(mesh), 5u);
  mesh.elements.push_back(testing::elementOf({0, 1, 2, 3}));
  EXPECT_EQ(covered.of(mesh), 15u);
}

TEST(CoveredArea, IsMeasuredOnceForEachElement) {
  Mesh mesh = leaningSquare();
  CoveredArea covered(0.1);
  mesh.elements.push_back(testing::elementOf({0, 1, 2}));
  EXPECT_EQ(covered.of(mesh), 5u);
  mesh.vertices[2] = mesh.vertices[1];
  EXPECT_EQ(covered.of(mesh), 5u);
}

TEST(CoveredArea, WithoutAUnitIsNotMeasured) {
  Mesh mesh = leaningSquare();
  mesh.elements.push_back(testing::elementOf({0, 1, 2}));
  EXPECT_EQ(CoveredArea(0).of(mesh), 0u);
}

}  // namespace
}  // namespace af2
