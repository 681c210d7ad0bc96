// Which shells certainly have their material inside.
#include "geometry/occ/base/outward_shell.h"

#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Shell.hxx>
#include <vector>

namespace af2::geometry {
namespace {

std::vector<TopoDS_Shape> facesOf(const TopoDS_Shape& shape) {
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) faces.push_back(it.Current());
  return faces;
}

TopoDS_Shell shellOf(const std::vector<TopoDS_Shape>& faces) {
  TopoDS_Shell shell;
  BRep_Builder().MakeShell(shell);
  for (const TopoDS_Shape& face : faces) BRep_Builder().Add(shell, face);
  return shell;
}

TopoDS_Shape box() { return BRepPrimAPI_MakeBox(1, 2, 3).Solid(); }

TopoDS_Shape pierced() {
  const TopoDS_Shape hole = BRepPrimAPI_MakeCylinder(gp_Ax2({0.5, 1, -1}, {0, 0, 1}), 0.4, 9);
  return BRepAlgoAPI_Cut(box(), hole).Shape();
}

std::vector<TopoDS_Shape> wholes() {
  gp_Trsf away;
  away.SetTranslation({1e4, -2e4, 7});
  return {box(),
          pierced(),
          pierced().Moved(away),
          BRepPrimAPI_MakeCylinder(1, 2).Solid(),
          BRepPrimAPI_MakeCone(2, 0, 1).Solid(),
          BRepPrimAPI_MakeSphere(1.5).Solid(),
          BRepPrimAPI_MakeTorus(3, 1).Solid()};
}

TEST(OutwardShell, IsThatOfASolid) {
  for (const TopoDS_Shape& solid : wholes()) EXPECT_TRUE(isOutwardShell(shellOf(facesOf(solid))));
}

TEST(OutwardShell, IsNotTurnedInsideOut) {
  for (const TopoDS_Shape& solid : wholes()) {
    const TopoDS_Shell shell = shellOf(facesOf(solid));
    EXPECT_FALSE(isOutwardShell(TopoDS::Shell(shell.Reversed())));
  }
}

TEST(OutwardShell, IsNotThatAroundACavity) {
  const TopoDS_Shape room = BRepPrimAPI_MakeBox({.2, .2, .2}, {.8, .8, .8}).Solid();
  const TopoDS_Shape hollow = BRepAlgoAPI_Cut(box(), room).Shape();
  int outward = 0, shells = 0;
  for (TopExp_Explorer it(hollow, TopAbs_SHELL); it.More(); it.Next(), ++shells)
    outward += isOutwardShell(TopoDS::Shell(it.Current()));
  EXPECT_EQ(shells, 2);
  EXPECT_EQ(outward, 1);
}

TEST(OutwardShell, LacksNoFaceAndHasNoneTwice) {
  for (const TopoDS_Shape& solid : {box(), pierced()}) {
    const std::vector<TopoDS_Shape> faces = facesOf(solid);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      std::vector<TopoDS_Shape> others = faces;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(f));
      EXPECT_FALSE(isOutwardShell(shellOf(others)));
      others = faces;
      others.push_back(faces[f]);
      EXPECT_FALSE(isOutwardShell(shellOf(others)));
    }
  }
  EXPECT_FALSE(isOutwardShell(shellOf({})));
}

TEST(OutwardShell, HasFacesThatAgree) {
  for (const TopoDS_Shape& solid : {box(), pierced()}) {
    const std::vector<TopoDS_Shape> faces = facesOf(solid);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      std::vector<TopoDS_Shape> turned = faces;
      turned[f].Reverse();
      EXPECT_FALSE(isOutwardShell(shellOf(turned))) << f;
    }
  }
}

/// OpenCASCADE makes a shell of each piece.
TEST(OutwardShell, IsInOnePiece) {
  std::vector<TopoDS_Shape> faces = facesOf(box());
  gp_Trsf away;
  away.SetTranslation({5, 0, 0});
  for (const TopoDS_Shape& face : facesOf(pierced().Moved(away))) faces.push_back(face);
  EXPECT_FALSE(isOutwardShell(shellOf(faces)));
}

}  // namespace
}  // namespace af2::geometry
