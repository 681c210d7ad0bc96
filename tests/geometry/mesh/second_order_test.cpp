#include "geometry/mesh/second_order.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/element.h"

namespace af2::geometry {
namespace {

using testing::elementOf;

std::vector<SideMiddles> straightMiddles(const ModelMesh& mesh) {
  std::vector<SideMiddles> middles(mesh.elements.size());
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const auto c = mesh.elements[e].vertices();
    for (std::size_t i = 0; i < c.size(); ++i)
      middles[e][i] =
          0.5 * (mesh.vertices[c[i].value] + mesh.vertices[c[(i + 1) % c.size()].value]);
  }
  return middles;
}

/// A square of two triangles and a quadrilateral beside it.
ModelMesh strip() {
  ModelMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}};
  mesh.elements = {elementOf({0, 1, 2}), elementOf({0, 2, 3}), elementOf({1, 4, 5, 2})};
  mesh.face = {1, 1, 1};
  return mesh;
}

TEST(SecondOrder, SharesTheMiddlesOfSides) {
  ModelMesh mesh = strip();
  mesh.wantedSizes.assign(6, 1);
  makeSecondOrder(mesh, straightMiddles(mesh));
  EXPECT_EQ(mesh.vertices.size(), 6u + 8);
  EXPECT_EQ(mesh.wantedSizes.size(), mesh.vertices.size());
  EXPECT_EQ(cornerVertices(mesh).size(), 6u);
  EXPECT_EQ(mesh.midsides[0][2], mesh.midsides[1][0]) << "the diagonal";
  EXPECT_EQ(mesh.midsides[0][1], mesh.midsides[2][3]);
  EXPECT_TRUE(mesh.straightened.empty());
  for (std::size_t e = 0; e < 3; ++e) EXPECT_NEAR(scaledJacobian(mesh, e), 1, 1e-12);
}

TEST(SecondOrder, PutsTheMiddlesOfBoundaryEdgesOnTheModelEdge) {
  ModelMesh mesh = strip();
  mesh.segments = {{VertexId(1u), VertexId(0u), 1, 1, {0.5, -0.1, 0}}};
  makeSecondOrder(mesh, straightMiddles(mesh));
  EXPECT_EQ(mesh.vertices[mesh.midsides[0][0].value], (Point3{0.5, -0.1, 0}));
  EXPECT_LT(scaledJacobian(mesh, 0), 1);
  EXPECT_GT(scaledJacobian(mesh, 0), 0.5);
}

TEST(SecondOrder, StraightensWhatWouldTurnOver) {
  ModelMesh mesh = strip();
  mesh.segments = {{VertexId(0u), VertexId(1u), 1, 1, {0.5, 0.6, 0}}};
  makeSecondOrder(mesh, straightMiddles(mesh));
  EXPECT_EQ(mesh.straightened, std::vector<ElementId>{ElementId(0u)});
  EXPECT_EQ(mesh.vertices[mesh.midsides[0][0].value], (Point3{0.5, 0, 0}));
  for (std::size_t e = 0; e < 3; ++e) EXPECT_GT(scaledJacobian(mesh, e), 0);
}

TEST(SecondOrder, StraightensSidesThatAreAlikeTogether) {
  const std::pair<SideEnds, SideEnds> alike{{VertexId(0u), VertexId(1u)},
                                            {VertexId(4u), VertexId(5u)}};
  for (const bool isAlike : {false, true}) {
    ModelMesh mesh = strip();
    mesh.segments = {{VertexId(0u), VertexId(1u), 1, 1, {0.5, 0.6, 0}},
                     {VertexId(4u), VertexId(5u), 2, 1, {2.2, 0.5, 0}}};
    makeSecondOrder(mesh, straightMiddles(mesh),
                    isAlike ? std::vector{alike} : std::vector<std::pair<SideEnds, SideEnds>>{});
    EXPECT_EQ(mesh.vertices[mesh.midsides[0][0].value], (Point3{0.5, 0, 0}));
    EXPECT_EQ(mesh.vertices[mesh.midsides[2][1].value].x, isAlike ? 2 : 2.2);
  }
}

TEST(SecondOrder, IsTakenBack) {
  ModelMesh mesh = strip();
  mesh.wantedSizes.assign(6, 1);
  const ModelMesh before = mesh;
  const std::vector<SideMiddles> middles = straightMiddles(mesh);
  makeSecondOrder(mesh, middles);
  const std::vector<SideMiddles> taken = takeSecondOrder(mesh);
  for (std::size_t e = 0; e < middles.size(); ++e)
    for (std::size_t i = 0; i < mesh.elements[e].vertices().size(); ++i)
      EXPECT_EQ(taken[e][i], middles[e][i]);
  EXPECT_EQ(mesh.vertices, before.vertices);
  EXPECT_EQ(mesh.wantedSizes, before.wantedSizes);
  EXPECT_TRUE(mesh.midsides.empty());
}

TEST(SecondOrder, JacobianSeesAFoldedQuad) {
  ModelMesh mesh = strip();
  std::vector<SideMiddles> middles = straightMiddles(mesh);
  makeSecondOrder(mesh, middles);
  mesh.vertices[mesh.midsides[2][1].value] = {0.9, 0.5, 0};
  EXPECT_LT(scaledJacobian(mesh, 2), 0);
}

}  // namespace
}  // namespace af2::geometry
