// Edges that are divided already.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/error.h"
#include "geometry/occ/run/mesh_model.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

ModelMesh mesh(const Model& model, const EdgePoints& points) {
  MeshingOptions options = testing::ofSize(0.4);
  options.edgePoints = points;
  ModelMesh result = testing::mesh(model, options);
  testing::expectComplete(result);
  return result;
}

/// The vertices of an edge in the order in which it runs.
std::vector<Point3> along(const ModelMesh& mesh, int edge) {
  std::vector<Point3> points;
  for (const EdgeSegment& segment : mesh.segments) {
    if (segment.edge != edge) continue;
    if (points.empty()) points.push_back(mesh.vertices[segment.from.value]);
    points.push_back(mesh.vertices[segment.to.value]);
  }
  return points;
}

std::vector<Point3> inner(std::vector<Point3> points) {
  return {points.begin() + 1, points.end() - 1};
}

TEST(GivenEdges, AreKeptBitForBitEitherWayRound) {
  const Model model = testing::box(2, 2, 2);
  for (int edge : {1, 4, 7, 12}) {
    const std::vector<Point3> ends = along(mesh(model, {}), edge);
    std::vector<Point3> given;
    for (const double t : {0.07, 0.1, 0.5, 0.81})
      given.push_back(ends.front() + t * (ends.back() - ends.front()));
    EXPECT_EQ(inner(along(mesh(model, {{edge, given}}), edge)), given);
    std::vector<Point3> backwards(given.rbegin(), given.rend());
    EXPECT_EQ(inner(along(mesh(model, {{edge, backwards}}), edge)), given);
  }
}

TEST(GivenEdges, MayBeASingleSegment) {
  EXPECT_EQ(along(mesh(testing::box(2, 2, 2), {{3, {}}}), 3).size(), 2u);
}

TEST(GivenEdges, ReproduceAMeshFromItsOwnSegments) {
  const Model model = testing::cylinder(1, 2);
  const ModelMesh first = mesh(model, {});
  EdgePoints points;
  for (int edge = 1; edge <= model.edgeCount(); ++edge) points[edge] = inner(along(first, edge));
  EXPECT_EQ(mesh(model, points).vertices.size(), first.vertices.size());
  EXPECT_EQ(along(mesh(model, points), 1), along(first, 1));
}

TEST(GivenEdges, AreRefusedIfTheyDoNotFit) {
  const Model model = testing::box(2, 2, 2);
  const std::vector<Point3> ends = along(mesh(model, {}), 1);
  const auto at = [&](double t) { return ends.front() + t * (ends.back() - ends.front()); };
  EXPECT_THROW(mesh(model, {{1, {at(0.5) + Point3{0.3, 0.3, 0.3}}}}), InputError);
  EXPECT_THROW(mesh(model, {{1, {at(0.2), at(0.6), at(0.4)}}}), InputError);
  EXPECT_THROW(mesh(model, {{1, {at(0.2), at(0.2)}}}), InputError);
  EXPECT_THROW(mesh(model, {{1, {at(1.5)}}}), InputError);
  EXPECT_THROW(mesh(model, {{99, {}}}), InputError);
  EXPECT_THROW(mesh(testing::cylinder(1, 2), {{1, {}}}), InputError)
      << "a closed edge needs three segments";
}

}  // namespace
}  // namespace af2::geometry
