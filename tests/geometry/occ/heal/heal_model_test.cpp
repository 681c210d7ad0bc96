// What healing mends, and that it tells of it.
#include "geometry/occ/heal/heal_model.h"

#include <gtest/gtest.h>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Circ.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>

#include "engine/base/error.h"
#include "geometry/occ/run/mesh_model.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/geometry/occ/run/dirt.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

using testing::mesh;
using testing::volumeOf;

/// How often healing made a change; words that its kind has.
std::size_t changesOf(const Model& model, const std::string& words) {
  std::size_t count = 0;
  for (const HealedChange& change : model.healing()->changes)
    if (change.what.find(words) != std::string::npos) count += change.count;
  return count;
}

/// The faces of a box with edges of their own, each moved outwards.
TopoDS_Compound looseBox(double gap) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(2, 2, 2).Shape();
  BRep_Builder builder;
  TopoDS_Compound loose;
  builder.MakeCompound(loose);
  const std::vector<gp_Vec> outwards{{-1, 0, 0}, {1, 0, 0},  {0, -1, 0},
                                     {0, 1, 0},  {0, 0, -1}, {0, 0, 1}};
  std::size_t i = 0;
  for (TopExp_Explorer it(box, TopAbs_FACE); it.More(); it.Next(), ++i) {
    gp_Trsf away;
    away.SetTranslation(gap * outwards[i]);
    builder.Add(loose, BRepBuilderAPI_Transform(it.Current(), away, true).Shape());
  }
  return loose;
}

TEST(HealModel, LeavesASoundModelAsItIs) {
  const Model box = testing::box(1, 2, 3);
  const Model healed = healModel(box);
  ASSERT_TRUE(healed.healing());
  EXPECT_TRUE(healed.healing()->changes.empty());
  EXPECT_GT(healed.healing()->tolerance, 0);
  EXPECT_EQ(mesh(box, 0.5).vertices, mesh(healed, 0.5).vertices);
}

TEST(HealModel, SewsLooseFacesToASolid) {
  const Model loose = testing::modelOf(looseBox(0));
  EXPECT_NE(volumeOf(mesh(loose, 1), {}), 0);
  const Model healed = healModel(loose);
  EXPECT_EQ(healed.edgeCount(), 12);
  EXPECT_EQ(changesOf(healed, "free edge sewn"), 24u);
  EXPECT_EQ(changesOf(healed, "solid made"), 1u);
  const ModelMesh result = mesh(healed, 1);
  EXPECT_NEAR(volumeOf(result, {}), 8, 1e-9);
  EXPECT_NEAR(volumeOf(result, {5, 5, 5}), 8, 1e-9);
}

TEST(HealModel, ClosesGapsWithinTheTolerance) {
  const Model apart = testing::modelOf(looseBox(1e-3));
  EXPECT_EQ(healModel(apart, {1e-5}).edgeCount(), 24);
  const Model healed = healModel(apart, {5e-3});
  EXPECT_EQ(healed.edgeCount(), 12);
  const ModelMesh result = mesh(healed, 1);
  EXPECT_TRUE(std::ranges::all_of(result.segments,
                                  [](const EdgeSegment& segment) { return segment.uses == 2; }));
  EXPECT_NEAR(volumeOf(result, {5, 5, 5}), 8, 0.03);
}

TEST(HealModel, TurnsFacesThatLookTheWrongWay) {
  BRep_Builder builder;
  TopoDS_Compound turned;
  builder.MakeCompound(turned);
  int i = 0;
  for (TopExp_Explorer it(looseBox(0), TopAbs_FACE); it.More(); it.Next(), ++i)
    builder.Add(turned, i % 2 == 0 ? it.Current().Reversed() : it.Current());
  const Model healed = healModel(testing::modelOf(turned));
  EXPECT_NEAR(volumeOf(mesh(healed, 1), {5, 5, 5}), 8, 1e-9);
}

TEST(HealModel, LeavesPartsThatTouchApart) {
  BRep_Builder builder;
  TopoDS_Compound parts;
  builder.MakeCompound(parts);
  builder.Add(parts, BRepPrimAPI_MakeBox(1, 1, 1).Shape());
  builder.Add(parts, BRepPrimAPI_MakeBox(gp_Pnt(1, 0, 0), 1, 1, 1).Shape());
  const Model healed = healModel(testing::modelOf(parts));
  EXPECT_EQ(healed.faceCount(), 12);
  EXPECT_EQ(healed.edgeCount(), 24);
}

TEST(HealModel, DoesNotTouchTheModelThatItIsGiven) {
  const Model apart = testing::modelOf(looseBox(1e-3));
  const ModelMesh before = mesh(apart, 1);
  healModel(apart, {5e-3});
  EXPECT_EQ(mesh(apart, 1).vertices, before.vertices);
  EXPECT_FALSE(apart.healing());
}

TEST(HealModel, ClosesALoopWithAStraightEdge) {
  const Model healed = healModel(testing::modelOf(testing::openLoop()));
  EXPECT_EQ(changesOf(healed, "open loop closed with a new edge"), 1u);
  EXPECT_EQ(changesOf(healed, "straight in its parameters, 1 long"), 1u);
  testing::expectComplete(mesh(healed, 0.3), 1, 1e-9);
}

/// A box without one of its edges, in one of the two faces beside it or in both.
Model boxWithoutEdge(int faces) {
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(box, TopAbs_EDGE, edges);
  BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (TopExp_Explorer it(box, TopAbs_FACE); it.More(); it.Next()) {
    TopoDS_Shape face = it.Current().EmptyCopied();
    TopoDS_Wire wire;
    builder.MakeWire(wire);
    bool lacksEdge = false;
    for (TopExp_Explorer edge(it.Current().Oriented(TopAbs_FORWARD), TopAbs_EDGE); edge.More();
         edge.Next()) {
      if (!edge.Current().IsSame(edges(1)) || faces == 0)
        builder.Add(wire, edge.Current());
      else
        lacksEdge = true;
    }
    if (lacksEdge) --faces;
    face.Orientation(TopAbs_FORWARD);
    builder.Add(face, wire);
    builder.Add(all, face.Oriented(it.Current().Orientation()));
  }
  return testing::modelOf(all);
}

TEST(HealModel, FacesThatLackTheSameEdgeShareANewOne) {
  for (const int faces : {1, 2}) {
    const Model healed = healModel(boxWithoutEdge(faces));
    EXPECT_EQ(changesOf(healed, "closed with a new edge"), faces == 2 ? 1u : 0u);
    EXPECT_EQ(changesOf(healed, "closed with an edge of another face"), 1u);
    const ModelMesh result = mesh(healed, 0.4);
    testing::expectComplete(result, 6, 1e-9);
    EXPECT_EQ(testing::eulerNumber(result), 2);
    EXPECT_NEAR(volumeOf(result), 1, 1e-9);
  }
}

TEST(HealModel, LeavesALoopOfOneStraightEdgeOpen) {
  const Model healed =
      healModel(testing::modelOf(testing::faceWithin({{0, 0, 0}, {1, 0, 0}}, {0, 1})));
  EXPECT_EQ(changesOf(healed, "open loop closed"), 0u);
}

/// An arc in space that is all that is left of a face: repairs would close it by a tolerance as
/// large as itself.
TEST(HealModel, DoesNotCloseGapsByLargeTolerances) {
  const TopoDS_Edge arc = BRepBuilderAPI_MakeEdge(
      gp_Circ(gp_Ax2({2, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1), 0, 1.5707963267948966);
  BRep_Builder builder;
  TopoDS_Face face;
  TopoDS_Wire wire;
  builder.MakeFace(face, new Geom_ToroidalSurface(gp_Ax3({0, 0, 0}, {0, 0, 1}), 2, 1), 1e-7);
  builder.MakeWire(wire);
  builder.Add(wire, arc);
  builder.Add(face, wire);
  const Model healed = healModel(testing::modelOf(face));
  for (int i = 1; i <= healed.vertexCount(); ++i)
    EXPECT_LT(BRep_Tool::Tolerance(healed.shape().vertex(i)), 1e-3);
  for (const FaceReport& report : mesh(healed, 0.3).faces)
    EXPECT_EQ(report.status, FaceStatus::Failed);
}

TEST(HealModel, RefusesANegativeTolerance) {
  EXPECT_THROW(healModel(testing::box(1, 1, 1), {-1}), InputError);
}

}  // namespace
}  // namespace af2::geometry
