#include "geometry/occ/iges/shifted_curves.h"

#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepLib.hxx>
#include <GCE2d_MakeSegment.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <IGESControl_Writer.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>

#include "geometry/io/report.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/geometry/occ/shapes.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

Model throughIges(const TopoDS_Shape& shape) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  IGESControl_Writer writer("MM", 0);
  writer.AddShape(shape);
  writer.ComputeModel();
  const testing::TestFile file("shifted.igs");
  writer.Write(file.path().c_str());
  return readModel(file.path());
}

double areaOf(const ModelMesh& mesh) {
  double area = 0;
  for (const auto& face : mesh.faces) area += face.area;
  return area;
}

void expectMeshedAsBefore(const TopoDS_Shape& shape) {
  const double wanted = areaOf(testing::mesh(shape, 0.3));
  const Model model = throughIges(shape);
  ASSERT_FALSE(model.notes().empty());
  EXPECT_NE(model.notes().front().find("shifted by a period"), std::string::npos);
  const ModelMesh mesh = testing::mesh(model, 0.3);
  EXPECT_EQ(statusOf(mesh), RunStatus::Complete);
  EXPECT_NEAR(areaOf(mesh), wanted, 1e-4 * wanted);
}

TEST(ShiftedCurves, OfAHoleOnTheSeamOfATorusAreReadAgain) {
  const TopoDS_Shape torus = BRepPrimAPI_MakeTorus(2, 0.7).Shape();
  const gp_Ax2 upwards({2, 0, -2}, gp::DZ());
  expectMeshedAsBefore(
      BRepAlgoAPI_Cut(torus, BRepPrimAPI_MakeCylinder(upwards, 0.3, 5).Shape()).Shape());
}

/// On a cylinder of radius 1, between lines in its parameters, from 0 to `turn` in u.
TopoDS_Face bandAround(double turn) {
  const Handle(Geom_Surface) surface = new Geom_CylindricalSurface(gp_Ax3(), 1);
  const gp_Pnt2d corners[] = {{0, 0}, {turn, 2}, {turn, 3}, {0, 1}};
  BRepBuilderAPI_MakeWire wire;
  for (int i = 0; i < 4; ++i)
    wire.Add(BRepBuilderAPI_MakeEdge(GCE2d_MakeSegment(corners[i], corners[(i + 1) % 4]).Value(),
                                     surface)
                 .Edge());
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(surface, wire.Wire()).Face();
  BRepLib::BuildCurves3d(face);
  return face;
}

TEST(ShiftedCurves, AreReplacedOnlyByThoseThatAreNot) {
  TopoDS_Shape helix = bandAround(8);
  EXPECT_TRUE(runsPastPeriod(bandAround(8)));
  EXPECT_FALSE(runsPastPeriod(bandAround(6)));
  EXPECT_EQ(replaceShifted(helix, [] { return bandAround(8); }), 0);
  EXPECT_EQ(replaceShifted(helix, [] { return TopoDS_Shape(); }), 0);
  EXPECT_EQ(replaceShifted(helix, [] { return bandAround(6); }), 1);
  EXPECT_FALSE(runsPastPeriod(TopoDS::Face(helix)));
}

TEST(ShiftedCurves, AreNotLookedForWhereNoneIs) {
  TopoDS_Shape band = bandAround(6);
  bool hasRead = false;
  replaceShifted(band, [&] {
    hasRead = true;
    return band;
  });
  EXPECT_FALSE(hasRead);
}

}  // namespace
}  // namespace af2::geometry
