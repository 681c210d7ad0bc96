// Faces that have vertices in common, but each an edge of its own between them.
#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>

#include <algorithm>
#include <map>

#include "geometry/occ/inspect/defects.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/geometry/occ/run/dirt.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

/// Two squares of side 1 that meet at x = 1, `gap` apart in the middle of that side.
struct Squares {
  TopoDS_Vertex low = BRepBuilderAPI_MakeVertex(gp_Pnt(1, 0, 0));
  TopoDS_Vertex high = BRepBuilderAPI_MakeVertex(gp_Pnt(1, 1, 0));

  TopoDS_Face beside(double x, const TopoDS_Edge& shared) const {
    const TopoDS_Vertex a = BRepBuilderAPI_MakeVertex(gp_Pnt(x, 0, 0));
    const TopoDS_Vertex b = BRepBuilderAPI_MakeVertex(gp_Pnt(x, 1, 0));
    BRepBuilderAPI_MakeWire wire(shared, BRepBuilderAPI_MakeEdge(high, b),
                                 BRepBuilderAPI_MakeEdge(b, a), BRepBuilderAPI_MakeEdge(a, low));
    return BRepBuilderAPI_MakeFace(gp_Pln(gp_Ax3({0, 0, 0}, {0, 0, 1})), wire.Wire());
  }
  TopoDS_Face left() const { return beside(0, BRepBuilderAPI_MakeEdge(low, high)); }
  TopoDS_Face right(double gap) const {
    const double radius = (0.25 + gap * gap) / (2 * gap);
    const gp_Circ arc(gp_Ax2({1 - radius + gap, 0.5, 0}, {0, 0, 1}), radius);
    return beside(2, BRepBuilderAPI_MakeEdge(arc, low, high));
  }
};

int openEdges(const ModelMesh& mesh) {
  std::map<std::pair<VertexId, VertexId>, int> edges;
  for (const Element& e : mesh.elements)
    for (std::size_t i = 0; i < 3; ++i) ++edges[std::minmax(e.corners[i], e.corners[(i + 1) % 3])];
  return static_cast<int>(
      std::ranges::count(edges, 1, [](const auto& edge) { return edge.second; }));
}

bool tellsOfTwin(const ModelMesh& mesh) {
  return std::ranges::any_of(mesh.faces, [](const FaceReport& face) {
    return std::ranges::any_of(face.attempts, [](const std::string& step) {
      return step.find("runs along edge") != std::string::npos;
    });
  });
}

TEST(TwinEdges, OfFacesThatWereNotSewnAreOne) {
  const Squares squares;
  const ModelMesh result =
      testing::mesh(testing::compoundOf({squares.left(), squares.right(1e-4)}), 0.25);
  testing::expectComplete(result, 2);
  EXPECT_EQ(openEdges(result), 6 * 4);
  EXPECT_TRUE(tellsOfTwin(result));
}

/// All other edges are given, so that only the twins can make both loops even: together.
TEST(TwinEdges, HaveOneNumberOfSegmentsForEvenLoops) {
  const Squares squares;
  const Model model = testing::modelOf(testing::compoundOf({squares.left(), squares.right(1e-4)}));
  MeshingOptions options = testing::ofSize(0.25);
  for (int edge = 1; edge <= model.edgeCount(); ++edge) {
    const auto [from, to] = testing::endsOf(model, edge);
    if (from.x == 1 && to.x == 1) continue;
    const int segments = from.x == to.x ? 3 : 4;
    std::vector<Point3>& points = options.edgePoints[edge];
    for (int i = 1; i < segments; ++i) points.push_back(from + double(i) / segments * (to - from));
  }
  ASSERT_EQ(options.edgePoints.size(), 6u);
  for (const bool evenLoops : {false, true}) {
    options.evenLoops = evenLoops;
    const ModelMesh result = testing::mesh(model, options);
    testing::expectComplete(result, 2);
    for (const FaceReport& face : result.faces)
      EXPECT_EQ(face.oddLoops.size(), evenLoops ? 0u : 1u);
    EXPECT_EQ(openEdges(result), 2 * (4 + 4 + 3)) << "the twins have the same vertices";
  }
}

TEST(TwinEdges, AreDefectsThatDependOnTheMeshSize) {
  const Squares squares;
  const Model model = testing::modelOf(testing::compoundOf({squares.left(), squares.right(1e-4)}));
  const std::vector<Defect> seen = findDefects(model, 0.25), apart = findDefects(model, 0.005);
  const auto found = std::ranges::find(seen, DefectKind::EdgeOnEdge, &Defect::kind);
  ASSERT_NE(found, seen.end());
  EXPECT_EQ(std::ranges::count(seen, DefectKind::EdgeOnEdge, &Defect::kind), 1);
  EXPECT_NEAR(found->place.x, 1, 1e-3);
  EXPECT_NEAR(found->extent, 1, 1e-6);
  EXPECT_EQ(found->detail.find("on edge "), 0u);
  EXPECT_EQ(std::ranges::count(apart, DefectKind::EdgeOnEdge, &Defect::kind), 0);
}

TEST(TwinEdges, ThatCanBeToldApartInTheMeshStayTwo) {
  const Squares squares;
  const ModelMesh result =
      testing::mesh(testing::compoundOf({squares.left(), squares.right(0.01)}), 0.25);
  testing::expectComplete(result, 2);
  EXPECT_EQ(openEdges(result), 8 * 4);
  EXPECT_FALSE(tellsOfTwin(result));
}

/// Joined, their elements would look to opposite sides.
TEST(TwinEdges, OfFacesThatLookToOppositeSidesStayTwo) {
  const Squares squares;
  const ModelMesh result =
      testing::mesh(testing::compoundOf({squares.left(), squares.right(1e-4).Reversed()}), 0.25);
  testing::expectComplete(result, 2);
  EXPECT_EQ(openEdges(result), 8 * 4);
}

}  // namespace
}  // namespace af2::geometry
