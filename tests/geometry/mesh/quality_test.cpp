#include "geometry/mesh/quality.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/planar_meshes.h"
#include "tests/support/small_meshes.h"

namespace af2::geometry {
namespace {

const double kHeight = std::sqrt(3.0) / 2;

double qualityOf(std::vector<Point3> corners) {
  const ModelMesh mesh = oneElement(std::move(corners));
  return shapeQuality(mesh.vertices, mesh.elements[0]);
}

TEST(ShapeQuality, IsOneForTheEquilateralTriangleOfAnySize) {
  EXPECT_NEAR(qualityOf({{0, 0, 0}, {1, 0, 0}, {0.5, kHeight, 0}}), 1, 1e-15);
  EXPECT_NEAR(qualityOf({{0, 0, 0}, {0, 1e-6, 0}, {0, 0.5e-6, kHeight * 1e-6}}), 1, 1e-12);
}

TEST(ShapeQuality, OfATriangleIsAreaOverSquaredEdges) {
  // area 1/2, squared edges 1 + 1 + 2
  EXPECT_NEAR(qualityOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), 4 * std::sqrt(3.0) * 0.5 / 4, 1e-15);
}

TEST(ShapeQuality, IsZeroForDegenerateElements) {
  EXPECT_EQ(qualityOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}), 0);
  EXPECT_EQ(qualityOf({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}), 0);
  EXPECT_EQ(qualityOf({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}), 0);
}

TEST(ShapeQuality, OfAQuadIsThatOfItsWorstCorner) {
  EXPECT_NEAR(qualityOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), 1, 1e-15);
  EXPECT_NEAR(qualityOf({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}), 0.8, 1e-15);
  EXPECT_NEAR(qualityOf({{0, 0, 0}, {1, 0, 0}, {1.5, kHeight, 0}, {0.5, kHeight, 0}}), kHeight,
              1e-15);
}

TEST(ShapeQuality, OfAQuadWithAReflexCornerIsNegative) {
  EXPECT_LT(qualityOf({{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}}), 0);
}

TEST(Percentile, InterpolatesBetweenNeighbours) {
  std::vector<double> values{4, 1, 3, 2, 5};
  EXPECT_EQ(percentile(values, 0), 1);
  EXPECT_EQ(percentile(values, 0.5), 3);
  EXPECT_NEAR(percentile(values, 0.05), 1.2, 1e-15);
  EXPECT_EQ(percentile(values, 1), 5);
  EXPECT_EQ(percentile({}, 0.5), 0);
}

TEST(MeasureQuality, FindsTheExtremeAnglesOfFlatElements) {
  const auto anglesOf = [](const std::vector<Point3>& corners) {
    return measureQuality(oneElement(corners));
  };
  for (const auto& corners : {std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
                              std::vector<Point3>{{1, 0, 0}, {2, 0, 0}, {0, 0, 0}}}) {
    EXPECT_EQ(anglesOf(corners).minAngle, 0);
    EXPECT_NEAR(anglesOf(corners).maxAngle, 180, 1e-12);
  }
  EXPECT_NEAR(anglesOf({{0, 0, 0}, {1, 0, 0}, {0, 1e-6, 0}}).minAngle, 180e-6 / 3.14159265, 1e-9);
  EXPECT_NEAR(anglesOf({{0, 0, 0}, {1, 0, 0}, {0, 1e-6, 0}}).maxAngle, 90, 1e-12);
}

TEST(MeasureQuality, OfAnEmptyMeshIsZero) {
  const MeshQuality quality = measureQuality({});
  EXPECT_EQ(quality.mean, 0);
  EXPECT_EQ(quality.maxAngle, 0);
}

TEST(MeasureQuality, CountsEachEdgeOnce) {
  // The cube has 12 edges of length 1 and, on five faces, a diagonal.
  ModelMesh cube = cubeMesh();
  cube.wantedSizes.assign(cube.vertices.size(), 0.6);
  const MeshQuality quality = measureQuality(cube);
  EXPECT_NEAR(quality.edges.mean, (12 + 5 * std::sqrt(2.0)) / 17 / 0.6, 1e-12);
  EXPECT_NEAR(quality.edges.p5, 1 / 0.6, 1e-12);
  EXPECT_NEAR(quality.edges.p95, std::sqrt(2.0) / 0.6, 1e-12);
  EXPECT_NEAR(quality.minAngle, 45, 1e-12);
  EXPECT_NEAR(quality.maxAngle, 90, 1e-12);
  EXPECT_EQ(quality.edges.histogram, (std::array<std::size_t, 10>{0, 0, 0, 0, 0, 0, 12, 5, 0, 0}));
  EXPECT_EQ(quality.edges.leastWanted, 0.6);
  EXPECT_EQ(quality.edges.leastLength, 1);
  EXPECT_NEAR(quality.edges.mostLength, std::sqrt(2.0), 1e-15);
}

TEST(MeasureQuality, CountsEdgesOfOneElement) {
  ModelMesh mesh = cubeMesh();
  EXPECT_EQ(measureQuality(mesh).freeEdges, 0u);
  mesh.elements.pop_back();
  EXPECT_GE(measureQuality(mesh).freeEdges, 3u);
  EXPECT_EQ(measureQuality(oneElement({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})).freeEdges, 3u);
}

TEST(MeasureQuality, NamesTheWorstElement) {
  ModelMesh mesh = oneElement({{0, 0, 0}, {1, 0, 0}, {0.5, 0.9, 0}});
  const VertexId far(mesh.vertices.size());
  mesh.vertices.push_back({0.5, -0.3, 0});
  mesh.elements.push_back({{VertexId(std::size_t{1}), VertexId(std::size_t{0}), far, {}}});
  mesh.face = {4, 7};
  const MeshQuality quality = measureQuality(mesh);
  EXPECT_EQ(quality.worstFace, 7);
  EXPECT_NEAR(distance(quality.worstPlace, {0.5, -0.1, 0}), 0, 1e-12);
}

TEST(MeasureQuality, HoldsAnEdgeAgainstTheSizesAtItsEnds) {
  ModelMesh mesh = oneElement({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  mesh.wantedSizes = {1, 3, 1};
  const double sum = 1 / 2.0 + std::sqrt(2.0) / 2 + 1;
  EXPECT_NEAR(measureQuality(mesh).edges.mean, sum / 3, 1e-12);
  mesh.wantedSizes.clear();
  EXPECT_EQ(measureQuality(mesh).edges.mean, 0);
}

/// With more elements and vertices than are looked at together.
TEST(MeasureQuality, OfALargeMeshDoesNotDependOnTheNumberOfThreads) {
  constexpr std::size_t kSquares = 300;
  ModelMesh mesh = squareGrid(kSquares);
  mesh.wantedSizes.assign(mesh.vertices.size(), 2);
  mesh.vertices[70'000].x += 0.3;
  const MeshQuality one = measureQuality(mesh, 1), two = measureQuality(mesh, 2);
  EXPECT_EQ(one.freeEdges, 4 * kSquares);
  std::size_t edges = 0;
  for (const std::size_t some : one.edges.histogram) edges += some;
  EXPECT_EQ(edges, 2 * kSquares * (kSquares + 1));
  EXPECT_NEAR(one.edges.mean, 0.5, 1e-5);
  EXPECT_NEAR(one.edges.leastLength, 0.7, 1e-12);
  EXPECT_NEAR(one.edges.mostLength, 1.3, 1e-12);
  EXPECT_NEAR(one.minAngle, 90 - std::atan(0.3) * 180 / std::acos(-1), 1e-12);
  EXPECT_NEAR(one.maxAngle, 90 + std::atan(0.3) * 180 / std::acos(-1), 1e-12);
  EXPECT_NEAR(distance(one.worstPlace, mesh.vertices[70'000]), 0, 1);
  EXPECT_EQ(one.mean, two.mean);
  EXPECT_EQ(one.p1, two.p1);
  EXPECT_EQ(one.worstPlace, two.worstPlace);
  EXPECT_EQ(one.minAngle, two.minAngle);
  EXPECT_EQ(one.maxAngle, two.maxAngle);
  EXPECT_EQ(one.edges.mean, two.edges.mean);
  EXPECT_EQ(one.edges.p5, two.edges.p5);
  EXPECT_EQ(one.edges.histogram, two.edges.histogram);
  EXPECT_EQ(one.freeEdges, two.freeEdges);
}

}  // namespace
}  // namespace af2::geometry
