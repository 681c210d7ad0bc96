// Models that fold back on themselves, or have a face twice.
#include "geometry/occ/faces/faces_on_faces.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <TopExp_Explorer.hxx>

#include <algorithm>

#include "geometry/occ/inspect/defects.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/geometry/occ/run/dirt.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

/// A plate of 2 by 1, a flap of 0.5 by 1 that is folded back onto it, and a wall at the end of
/// that.
TopoDS_Shape foldedFlap() {
  const auto vertex = [](double x, double y, double z = 0) {
    return BRepBuilderAPI_MakeVertex(gp_Pnt(x, y, z)).Vertex();
  };
  const auto edge = [](const TopoDS_Vertex& from, const TopoDS_Vertex& to) {
    return BRepBuilderAPI_MakeEdge(from, to).Edge();
  };
  const auto face = [](const gp_Dir& normal, const gp_Pnt& at, std::vector<TopoDS_Edge> edges) {
    BRepBuilderAPI_MakeWire wire;
    for (const TopoDS_Edge& side : edges) wire.Add(side);
    return BRepBuilderAPI_MakeFace(gp_Pln(gp_Ax3(at, normal)), wire.Wire()).Face();
  };
  const TopoDS_Vertex a = vertex(0, 0), b = vertex(0.5, 0), c = vertex(2, 0), d = vertex(2, 1),
                      e = vertex(0.5, 1), f = vertex(0, 1), g = vertex(0.5, 0, 1),
                      h = vertex(0.5, 1, 1);
  const TopoDS_Edge ab = edge(a, b), bc = edge(b, c), cd = edge(c, d), de = edge(d, e),
                    ef = edge(e, f), fa = edge(f, a), eb = edge(e, b);
  const auto back = [](const TopoDS_Edge& side) { return TopoDS::Edge(side.Reversed()); };
  return testing::compoundOf(
      {face({0, 0, 1}, {0, 0, 0}, {ab, bc, cd, de, ef, fa}),
       face({0, 0, -1}, {0, 0, 0}, {back(ab), back(fa), back(ef), eb}),
       face({1, 0, 0}, {0.5, 0, 0}, {back(eb), edge(e, h), edge(h, g), edge(g, b)})});
}

TEST(FacesOnFaces, AFlapThatIsFoldedBackHasNoElementsNorWhatItLiesOn) {
  const Model model = testing::modelOf(foldedFlap());
  const std::vector<FaceOnFace> found = facesOnFaces(model.shape(), 1);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].face, 2);
  EXPECT_EQ(found[0].under, 1);
  EXPECT_EQ(found[0].folds.size(), 3u);
  const ModelMesh result = testing::mesh(model, 0.25);
  testing::expectComplete(result, 2.5, 1e-9);
  EXPECT_NEAR(testing::areaOf(result, 1), 1.5, 1e-9);
  EXPECT_EQ(result.faces[1].elements, 0u);
  EXPECT_NE(result.faces[1].reason.find("lies on face 1, folded back"), std::string::npos);
  EXPECT_NE(result.faces[0].attempts[0].find("face 2 lies on it"), std::string::npos);
}

TEST(FacesOnFaces, AreDefects) {
  const std::vector<Defect> defects = findDefects(testing::modelOf(foldedFlap()), 0.25);
  const auto found = std::ranges::find(defects, DefectKind::FaceOnFace, &Defect::kind);
  ASSERT_NE(found, defects.end());
  EXPECT_EQ(found->face, 2);
  EXPECT_EQ(found->detail, "lies on face 1, folded back");
}

/// Alone, it can be meshed as it is.
TEST(FacesOnFaces, AFlapAloneHasElements) {
  MeshingOptions options = testing::ofSize(0.25);
  options.faces = {2};
  testing::expectComplete(testing::mesh(testing::modelOf(foldedFlap()), options), 0.5, 1e-9);
}

TEST(FacesOnFaces, OfAFaceThatIsThereTwiceOneHasElements) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  const TopoDS_Face side = TopoDS::Face(TopExp_Explorer(box, TopAbs_FACE).Current());
  BRep_Builder builder;
  TopoDS_Face again;
  builder.MakeFace(again, BRep_Tool::Surface(side), 1e-7);
  for (TopoDS_Iterator wire(side.Oriented(TopAbs_FORWARD)); wire.More(); wire.Next())
    builder.Add(again, wire.Value());
  const ModelMesh result =
      testing::mesh(testing::compoundOf({box, again.Oriented(side.Orientation()).Reversed()}), 0.3);
  testing::expectComplete(result, 6, 1e-9);
  EXPECT_EQ(testing::eulerNumber(result), 2);
  ASSERT_EQ(result.faces.size(), 7u);
  EXPECT_EQ(result.faces[6].elements, 0u);
  EXPECT_NE(result.faces[6].reason.find("is face 1 again"), std::string::npos);
}

/// A slit that is open by less than is told apart here: without its sides, the faces around it
/// would not meet.
TEST(FacesOnFaces, TheSidesOfASlitAreNone) {
  const TopoDS_Face outline = testing::polygon({{0, 0, 0},
                                                {10, 0, 0},
                                                {10, 6, 0},
                                                {0, 6, 0},
                                                {0, 3 + 5e-6, 0},
                                                {2, 3, 0},
                                                {0, 3 - 5e-6, 0}});
  const Model slit = testing::modelOf(BRepPrimAPI_MakePrism(outline, gp_Vec(0, 0, 2)).Shape());
  EXPECT_TRUE(facesOnFaces(slit.shape(), 1).empty());
  const ModelMesh result = testing::mesh(slit, 0.3);
  const auto failed = std::ranges::find(result.faces, FaceStatus::Failed, &FaceReport::status);
  ASSERT_NE(failed, result.faces.end());
  EXPECT_NE(failed->reason.find("encloses an angle of"), std::string::npos) << failed->reason;
  EXPECT_EQ(failed->reason.find("crosses itself"), std::string::npos);
}

TEST(FacesOnFaces, ThereAreNoneOnSoundModels) {
  const TopoDS_Face wedge = testing::polygon({{0, 0, 0}, {10, 0, 0}, {10, 0.05, 0}});
  for (const TopoDS_Shape& sound :
       {BRepPrimAPI_MakeBox(1, 1, 1).Shape(), BRepPrimAPI_MakeCylinder(1, 2).Shape(),
        testing::sharedFace(), BRepPrimAPI_MakePrism(wedge, gp_Vec(0, 0, 1)).Shape()})
    EXPECT_TRUE(facesOnFaces(testing::modelOf(sound).shape(), 1).empty());
}

}  // namespace
}  // namespace af2::geometry
