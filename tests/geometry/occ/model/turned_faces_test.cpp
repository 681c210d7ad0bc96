#include "geometry/occ/model/turned_faces.h"

#include <gtest/gtest.h>
#include <BRepTools_ReShape.hxx>

#include <algorithm>
#include <numbers>

#include "geometry/occ/faces/face_area.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/geometry/occ/run/dirt.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

using std::numbers::pi;
using testing::sphereOf;

/// A part of a ball between two half discs.
TopoDS_Shape wedgeOfBall(double angle) {
  return BRepPrimAPI_MakeSphere(gp_Ax2({0, 0, 0}, {0, 0, 1}), 1, angle).Shape();
}

double areaOf(const TopoDS_Face& face) {
  return geometry::areaOf(testing::modelOf(face).shape(), 1);
}

TEST(TurnedFaces, TheRestOfASphereHasTheSameEdgesAndLooksToTheOtherSide) {
  const TopoDS_Face face = sphereOf(wedgeOfBall(pi / 2));
  EXPECT_NEAR(areaOf(face), pi, 1e-9);
  const TopoDS_Face rest = restOf(face);
  ASSERT_FALSE(rest.IsNull());
  EXPECT_NEAR(areaOf(rest), 3 * pi, 1e-9);
  EXPECT_NE(rest.Orientation(), face.Orientation());
  EXPECT_NEAR(areaOf(restOf(rest)), pi, 1e-9);
}

TEST(TurnedFaces, WhatDoesNotRunFromPoleToPoleHasNoRest) {
  EXPECT_TRUE(restOf(sphereOf(BRepPrimAPI_MakeSphere(1).Shape())).IsNull()) << "a whole sphere";
  EXPECT_TRUE(restOf(sphereOf(BRepPrimAPI_MakeSphere(1, 0, pi / 2, pi / 2).Shape())).IsNull())
      << "an octant: one pole";
  EXPECT_TRUE(restOf(testing::plane({testing::rectangle(0, 0, 1, 1)})).IsNull());
}

/// As readers leave it: the sphere is the rest of what it should be, and the shell looks inwards.
ReadShape misread(const TopoDS_Shape& solid) {
  const TopoDS_Face right = sphereOf(solid);
  BRepTools_ReShape replacing;
  replacing.Replace(right, restOf(right));
  const TopoDS_Shape shell = TopExp_Explorer(replacing.Apply(solid), TopAbs_SHELL).Current();
  TopoDS_Solid inwards;
  BRep_Builder().MakeSolid(inwards);
  BRep_Builder().Add(inwards, shell.Reversed());
  ReadShape read;
  read.shape = inwards;
  const TopoDS_Face wrong = sphereOf(read.shape);
  read.nameOf = [wrong](const TopoDS_Face& face) {
    return std::string(face.IsPartner(wrong) ? "name of the wrong one" : "");
  };
  read.groups.push_back({"ball", GroupKind::Part, {wrong}});
  return read;
}

TEST(TurnedFaces, AreTurnedBackWithTheirShell) {
  ReadShape read = misread(wedgeOfBall(pi / 2));
  const TopoDS_Face wrong = sphereOf(read.shape);
  turnBackFaces(read, [&](const TopoDS_Face& face) { return !face.IsPartner(wrong); });
  ASSERT_EQ(read.notes.size(), 1u);
  EXPECT_TRUE(sphereOf(read.shape).IsPartner(read.groups[0].shapes[0]));
  EXPECT_EQ(read.nameOf(sphereOf(read.shape)), "name of the wrong one");
  const ModelMesh result = testing::mesh(read.shape, 0.2);
  testing::expectComplete(result, 2 * pi);
  EXPECT_NEAR(testing::volumeOf(result), pi / 3, 0.03);
  EXPECT_EQ(testing::eulerNumber(result), 2);
}

/// A shape with one inside it that has a place of its own.
TopoDS_Shape compoundOf(const TopoDS_Shape& shape) {
  TopoDS_Compound compound;
  BRep_Builder().MakeCompound(compound);
  BRep_Builder().Add(compound, shape);
  return compound;
}

TopoDS_Shape moved(const TopoDS_Shape& shape, double along) {
  gp_Trsf place;
  place.SetRotation(gp_Ax1({0, 0, 0}, {1, 0, 0}), 0.5);
  place.SetTranslationPart({along, 2, 0});
  return shape.Moved(place);
}

TopoDS_Shape solidWithMovedShell(const TopoDS_Shape& solid) {
  TopoDS_Solid made;
  BRep_Builder().MakeSolid(made);
  BRep_Builder().Add(made, moved(TopoDS_Iterator(solid).Value(), 4));
  return made;
}

/// The replacement did not find shells under a location; the note said "corrected" all the same.
TEST(TurnedFaces, AreTurnedBackWhereverTheirPartIsPlaced) {
  const ReadShape plain = misread(wedgeOfBall(pi / 2));
  for (const TopoDS_Shape& placed :
       {moved(plain.shape, 3), compoundOf(moved(plain.shape, 3)),
        moved(compoundOf(moved(plain.shape, 3)), 5), solidWithMovedShell(plain.shape),
        moved(solidWithMovedShell(plain.shape), 7)}) {
    ReadShape read = plain;
    read.shape = placed;
    const TopoDS_Face wrong = sphereOf(read.shape);
    turnBackFaces(read, [&](const TopoDS_Face& face) { return !face.IsPartner(wrong); });
    EXPECT_EQ(read.notes.size(), 1u);
    EXPECT_FALSE(sphereOf(read.shape).IsPartner(wrong));
    const ModelMesh result = testing::mesh(read.shape, 0.2);
    testing::expectComplete(result, 2 * pi);
    EXPECT_NEAR(testing::volumeOf(result), pi / 3, 0.03);
  }
}

TEST(TurnedFaces, StayIfTheFileSaysSo) {
  ReadShape read = misread(wedgeOfBall(pi / 2));
  const TopoDS_Face wrong = sphereOf(read.shape);
  turnBackFaces(read, [](const TopoDS_Face&) { return true; });
  EXPECT_TRUE(sphereOf(read.shape).IsSame(wrong));
  // As many are turned as are not.
  turnBackFaces(read, [](const TopoDS_Face& face) {
    return BRepAdaptor_Surface(face).GetType() == GeomAbs_Plane
               ? face.Orientation() == TopAbs_FORWARD
               : true;
  });
  EXPECT_TRUE(read.notes.empty());
}

}  // namespace
}  // namespace af2::geometry
