#include "geometry/occ/read/crossed_faces.h"

#include <gtest/gtest.h>
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepTools_ReShape.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_TrimmedCurve.hxx>

#include <numbers>

#include "geometry/occ/model/turned_faces.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/geometry/occ/run/dirt.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

using std::numbers::pi;

TopoDS_Shape block(const gp_Pnt& low, const gp_Pnt& high) {
  return BRepPrimAPI_MakeBox(low, high).Shape();
}

enum class Round { Sphere, TurnedSpline };

/// A quarter of a ball.
TopoDS_Shape quarterOf(Round round) {
  const gp_Pnt middle(0, 0, 0);
  const gp_Dir start(-1, 0, 0);
  if (round == Round::Sphere)
    return BRepPrimAPI_MakeSphere(gp_Ax2(middle, gp::DZ(), start), 1, pi / 2).Shape();
  const Handle(Geom_Circle) circle = new Geom_Circle(gp_Ax2(middle, gp::DY(), start), 1);
  const Handle(Geom_Curve) arc =
      GeomConvert::CurveToBSplineCurve(new Geom_TrimmedCurve(circle, -pi / 2, pi / 2));
  const TopoDS_Edge around = BRepBuilderAPI_MakeEdge(arc).Edge();
  const TopoDS_Edge along =
      BRepBuilderAPI_MakeEdge(TopExp::LastVertex(around), TopExp::FirstVertex(around)).Edge();
  const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(around, along).Wire();
  return BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(wire).Face(), gp::OZ(), pi / 2).Shape();
}

TopoDS_Face roundFaceOf(const TopoDS_Shape& shape) {
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face face = TopoDS::Face(it.Current());
    if (BRepAdaptor_Surface(face).GetType() != GeomAbs_Plane) return face;
  }
  return {};
}

/// A block with a quarter of a ball taken out at an edge, and a rod on an arm that reaches to where
/// the other three quarters would be.
TopoDS_Shape part(Round round = Round::Sphere) {
  const TopoDS_Shape quarter = quarterOf(round);
  const TopoDS_Shape hollow = BRepAlgoAPI_Cut(block({-3, -3, -3}, {0, 0, 3}), quarter).Shape();
  const TopoDS_Shape arm = block({-3, -3, -3}, {3, -2, 3}),
                     rod = block({0.4, -2, -0.1}, {0.6, -0.3, 0.1});
  const TopoDS_Shape all = BRepAlgoAPI_Fuse(BRepAlgoAPI_Fuse(hollow, arm).Shape(), rod).Shape();
  return TopExp_Explorer(all, TopAbs_SOLID).Current();
}

const double kVolume = 54 - pi / 3 + 18 + 0.2 * 0.2 * 1.7;

ReadShape readAs(const TopoDS_Shape& shape) {
  ReadShape read;
  read.shape = shape;
  return read;
}

/// The same with the rest of the round face.
TopoDS_Shape withRest(const TopoDS_Shape& shape) {
  const TopoDS_Face face = roundFaceOf(shape), rest = restOf(face);
  EXPECT_FALSE(rest.IsNull());
  BRepTools_ReShape replacing;
  replacing.Replace(face, rest);
  return replacing.Apply(shape);
}

TEST(CrossedFaces, BecomeTheRestThatNothingCrosses) {
  for (const auto& [round, isReversed] :
       {std::pair(Round::Sphere, false), {Round::Sphere, true}, {Round::TurnedSpline, false}}) {
    const TopoDS_Shape wrong = withRest(part(round));
    const TopoDS_Shape shell = TopExp_Explorer(wrong, TopAbs_SHELL).Current();
    ReadShape read = readAs(isReversed ? shell.Reversed() : shell);
    turnBackCrossedFaces(read);
    ASSERT_EQ(read.notes.size(), 1u);
    EXPECT_NE(read.notes[0].find("1 faces between two poles"), std::string::npos);
    const ModelMesh result = testing::mesh(read.shape, 0.5);
    testing::expectComplete(result);
    EXPECT_NEAR(testing::volumeOf(result), kVolume, 0.1);
  }
}

TEST(CrossedFaces, AreNoneInAPartAsItShouldBe) {
  for (const Round round : {Round::Sphere, Round::TurnedSpline}) {
    ReadShape read = readAs(part(round));
    turnBackCrossedFaces(read);
    EXPECT_TRUE(read.notes.empty());
  }
}

/// Either of the two would do.
TEST(CrossedFaces, AreNoneIfNothingCrosses) {
  const TopoDS_Shape wedge =
      BRepPrimAPI_MakeSphere(gp_Ax2({0, 0, 0}, {0, 0, 1}), 1, pi / 2).Shape();
  for (const TopoDS_Shape& shape : {wedge, withRest(wedge)}) {
    ReadShape read = readAs(shape);
    turnBackCrossedFaces(read);
    EXPECT_TRUE(read.notes.empty());
  }
}

}  // namespace
}  // namespace af2::geometry
