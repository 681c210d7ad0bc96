#include "geometry/occ/faces/solid_volume.h"

#include <gtest/gtest.h>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include <numbers>

#include "tests/geometry/occ/shapes.h"

namespace af2::geometry {
namespace {

using std::numbers::pi;

double volumeOf(const Model& model) { return volumeOfSolids(model.shape()).value_or(0); }

/// Held against OpenCASCADE's own integration, as it is, turned inside out, elsewhere, and in a
/// mirror, where surfaces have axes of the other handedness.
void expectVolumeOfOpenCascade(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties, 1e-9);
  const double expected = properties.Mass();
  EXPECT_NEAR(volumeOf(testing::modelOf(shape)), expected, 1e-5 * expected);
  EXPECT_NEAR(volumeOf(testing::modelOf(shape.Reversed())), -expected, 1e-5 * expected);
  gp_Trsf away;
  away.SetTranslation(gp_Vec(1000, -2000, 500));
  EXPECT_NEAR(volumeOf(testing::modelOf(shape.Moved(away))), expected, 1e-5 * expected);
  gp_Trsf mirror;
  mirror.SetMirror(gp_Ax2({1, 2, 3}, {1, 2, -2}));
  EXPECT_NEAR(volumeOf(testing::modelOf(BRepBuilderAPI_Transform(shape, mirror, true).Shape())),
              expected, 1e-5 * expected);
}

TEST(SolidVolume, OfSimpleShapesIsThatOfTheFormulas) {
  EXPECT_NEAR(volumeOf(testing::box(1, 2, 3)), 6, 1e-12);
  EXPECT_NEAR(volumeOf(testing::cylinder(2, 3)), 12 * pi, 1e-8);
  EXPECT_NEAR(volumeOf(testing::sphere(2)), 32 * pi / 3, 1e-8);
  EXPECT_NEAR(volumeOf(testing::torus(3, 1)), 6 * pi * pi, 1e-8);
  EXPECT_NEAR(volumeOf(testing::cone(3, 0, 4)), 12 * pi, 1e-8);
}

TEST(SolidVolume, IsThatOfOpenCascade) {
  expectVolumeOfOpenCascade(testing::drilledBlock());
  expectVolumeOfOpenCascade(
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeSphere(2).Shape(), testing::drilledBlock()));
  expectVolumeOfOpenCascade(
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeTorus(3, 1).Shape(), testing::drilledBlock()));
  expectVolumeOfOpenCascade(
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeCone(3, 1, 4).Shape(), testing::drilledBlock()));
  expectVolumeOfOpenCascade(
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(6, 6, 6).Shape(),
                      BRepPrimAPI_MakeCylinder(gp_Ax2({1, 1, 7}, {1, 2, -3}), 1.5, 9, 4).Shape()));
  expectVolumeOfOpenCascade(BRepBuilderAPI_NurbsConvert(testing::drilledBlock()).Shape());
}

/// The axis of a hole begins far from the model; the top is nearly a plane.
TEST(SolidVolume, IsThatOfOpenCascadeWhereSurfacesAreFarLarger) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(6, 6, 6).Shape();
  expectVolumeOfOpenCascade(BRepAlgoAPI_Cut(
      block, BRepPrimAPI_MakeCylinder(gp_Ax2({3, 3, -1e6}, {0, 0, 1}), 1, 2e6).Shape()));
  for (const double radius : {1e3, 1e5}) {
    expectVolumeOfOpenCascade(BRepAlgoAPI_Common(
        block, BRepPrimAPI_MakeSphere(gp_Pnt(2, 3, 5 - radius), radius).Shape()));
    expectVolumeOfOpenCascade(BRepAlgoAPI_Common(
        block,
        BRepPrimAPI_MakeCylinder(gp_Ax2({2, -1, 5 - radius}, {0, 1, 0}), radius, 9).Shape()));
  }
  expectVolumeOfOpenCascade(BRepAlgoAPI_Common(
      block, BRepPrimAPI_MakeCone(gp_Ax2({3, 3, -1}, {0, 0, 1}), 2.9, 2.8999, 9)));
}

/// A hollow in a solid, and one solid inside it.
TEST(SolidVolume, CountsHollowsAndSeveralSolids) {
  const TopoDS_Shape hollow = BRepAlgoAPI_Cut(
      BRepPrimAPI_MakeBox(gp_Pnt(-3, -3, -3), 6, 6, 6).Shape(), BRepPrimAPI_MakeSphere(2).Shape());
  TopoDS_Compound both;
  BRep_Builder builder;
  builder.MakeCompound(both);
  builder.Add(both, hollow);
  builder.Add(both, BRepPrimAPI_MakeSphere(1).Shape());
  EXPECT_NEAR(volumeOf(testing::modelOf(both)), 216 - 28 * pi / 3, 1e-6);
}

TEST(SolidVolume, IsNoneForFacesOfNoSolid) {
  const TopoDS_Shape face = TopExp_Explorer(testing::drilledBlock(), TopAbs_FACE).Current();
  EXPECT_FALSE(volumeOfSolids(testing::modelOf(face).shape()));
}

}  // namespace
}  // namespace af2::geometry
