// Models as they should not be: each ends in a sound mesh, or in a named fault of the faces that
// are to blame.
#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "engine/base/error.h"
#include "geometry/occ/run/mesh_model.h"
#include "tests/geometry/occ/in_iges.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/geometry/occ/run/dirt.h"
#include "tests/support/model_mesh.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

using std::numbers::pi;

using testing::areaOf;
using testing::mesh;
using testing::modelOf;
using testing::volumeOf;

/// Every face complete, all checks passed, nothing crosses.
void expectSound(const ModelMesh& mesh, double area, double tolerance = 1e-9) {
  testing::expectComplete(mesh);
  EXPECT_NEAR(areaOf(mesh), area, tolerance * area);
  EXPECT_EQ(testing::crossingsOf(mesh), 0u);
}

void expectClosed(const ModelMesh& mesh) {
  for (const EdgeSegment& segment : mesh.segments) EXPECT_EQ(segment.uses, 2);
}

/// A block of 3 x 2 x 1 with a hole, `scale` times as large.
TopoDS_Shape drilledBlock(double scale) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(3, 2, 1).Shape();
  const TopoDS_Shape drill =
      BRepPrimAPI_MakeCylinder(gp_Ax2({1.2, 1, -1}, {0, 0, 1}), 0.4, 3).Shape();
  gp_Trsf larger;
  larger.SetScale({0, 0, 0}, scale);
  return BRepBuilderAPI_Transform(BRepAlgoAPI_Cut(block, drill).Shape(), larger, true).Shape();
}
constexpr double kBlockVolume = 6 - pi * 0.16, kBlockArea = 22 - 2 * pi * 0.16 + 2 * pi * 0.4;

TEST(Dirt, TheScaleOfAModelDoesNotMatter) {
  const ModelMesh plain = mesh(drilledBlock(1), 0.3);
  expectSound(plain, kBlockArea, 0.02);
  for (const double scale : {1e-6, 1e-3, 25.4, 1e6}) {
    SCOPED_TRACE(scale);
    const ModelMesh scaled = mesh(drilledBlock(scale), 0.3 * scale);
    expectSound(scaled, kBlockArea * scale * scale, 0.02);
    expectClosed(scaled);
    EXPECT_NEAR(volumeOf(scaled), kBlockVolume * std::pow(scale, 3), 0.05 * std::pow(scale, 3));
    EXPECT_NEAR(static_cast<double>(scaled.elements.size()),
                static_cast<double>(plain.elements.size()),
                0.1 * static_cast<double>(plain.elements.size()));
  }
}

TEST(Dirt, AModelTooFarFromTheOriginForItsSizeIsRefused) {
  gp_Trsf away;
  away.SetTranslation({1e12, 0, 0});
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 1, 1).Shape().Moved(away);
  expectSound(mesh(box, 0.5), 6);
  try {
    mesh(box, 0.1);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(
        error.what(),
        "coordinates of 1e+12 are exact only to 0.000222045, which is too coarse for elements of "
        "size 0.1; move the model to the origin, or ask for larger elements");
  }
}

TEST(Dirt, InchesAndMicronsBecomeMillimetres) {
  for (const auto& [unit, name] : {std::pair("INCH", "inch"), std::pair("UM", "micrometre")}) {
    SCOPED_TRACE(unit);
    const testing::TestFile file("block.step");
    STEPControl_Controller::Init();  // knows the settings
    Interface_Static::SetCVal("write.step.unit", unit);
    STEPControl_Writer writer;
    writer.Transfer(drilledBlock(1), STEPControl_AsIs);
    ASSERT_EQ(writer.Write(file.path().c_str()), IFSelect_RetDone);
    Interface_Static::SetCVal("write.step.unit", "MM");
    const Model model = readModel(file.path());
    EXPECT_EQ(model.unit(), "mm");
    std::string told = model.fileUnit();
    std::ranges::transform(told, told.begin(), [](unsigned char c) { return std::tolower(c); });
    EXPECT_EQ(told, name);
    const ModelMesh result = mesh(model, 0.3);
    expectSound(result, kBlockArea, 0.02);
    EXPECT_NEAR(volumeOf(result), kBlockVolume, 0.05);
  }
}

/// In IGES all faces are loose.
Model throughIges(const TopoDS_Shape& shape) {
  const testing::TestFile file("shape.iges", testing::inIges({shape}));
  return readModel(file.path());
}

TopoDS_Shape movedUp(const TopoDS_Shape& shape, double height) {
  gp_Trsf up;
  up.SetTranslation({0, 0, height});
  return shape.Moved(up);
}

/// A bolt fills a hole: faces of both lie on each other, and four meet at the rims of the hole.
TEST(Dirt, LooseFacesOfPartsThatTouchAreSewnPartByPart) {
  const gp_Ax2 axis({2, 2, 0}, {0, 0, 1});
  const TopoDS_Shape plate = BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(4, 4, 1).Shape(),
                                             BRepPrimAPI_MakeCylinder(axis, 1, 1).Shape())
                                 .Shape();
  const TopoDS_Shape bolt =
      BRepAlgoAPI_Fuse(BRepPrimAPI_MakeCylinder(axis, 1, 1).Shape(),
                       BRepPrimAPI_MakeBox(gp_Pnt(0.5, 0.5, 1), 3, 3, 1).Shape())
          .Shape();
  std::vector<TopoDS_Shape> faces;
  for (const TopoDS_Shape& part : {plate, bolt})
    for (TopExp_Explorer it(part, TopAbs_FACE); it.More(); it.Next()) faces.push_back(it.Current());
  const Model model = throughIges(testing::compoundOf(faces));
  EXPECT_EQ(model.edgeCount(), modelOf(plate).edgeCount() + modelOf(bolt).edgeCount());
  const ModelMesh result = mesh(model, 0.4);
  const double ofPlate = 2 * (16 - pi) + 16 + 2 * pi, ofBolt = 2 * 9 + 12 + 2 * pi;
  expectSound(result, ofPlate + ofBolt, 0.02);
  expectClosed(result);
  EXPECT_EQ(testing::eulerNumber(result), 0 + 2) << "a ring and a bolt";
}

/// Two halves of a ball, base to base: four faces meet at the rim, and poles are no open edges.
TEST(Dirt, LooseFacesOfPartsWithPolesAreSewnPartByPart) {
  std::vector<TopoDS_Shape> faces;
  for (const double up : {1.0, -1.0}) {
    const TopoDS_Shape half =
        BRepPrimAPI_MakeSphere(gp_Ax2({0, 0, 0}, {0, 0, up}), 1, 0, pi / 2).Shape();
    for (TopExp_Explorer it(half, TopAbs_FACE); it.More(); it.Next()) faces.push_back(it.Current());
  }
  const ModelMesh result = mesh(throughIges(testing::compoundOf(faces)), 0.2);
  expectSound(result, 2 * 3 * pi, 0.03);
  expectClosed(result);
  EXPECT_EQ(testing::eulerNumber(result), 4) << "two pieces";
}

/// How exact a file is, it may not say: a gap of a thousandth of the model is none if nothing else
/// is left open.
TEST(Dirt, LooseFacesAreSewnAcrossWiderGapsIfThatClosesTheModel) {
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer it(BRepPrimAPI_MakeBox(10, 10, 10).Shape(), TopAbs_FACE); it.More();
       it.Next())
    faces.push_back(it.Current());
  faces.back() = movedUp(faces.back(), 0.01);
  const Model model = throughIges(testing::compoundOf(faces));
  EXPECT_EQ(model.edgeCount(), 12);
  const ModelMesh result = mesh(model, 2);
  expectSound(result, 600, 0.001);
  expectClosed(result);
}

TEST(Dirt, SheetsCloseToEachOtherAreNotSewnTogether) {
  const TopoDS_Shape sheet = BRepBuilderAPI_MakeFace(gp_Pln(), 0, 10, 0, 10).Shape();
  const Model model = throughIges(testing::compoundOf({sheet, movedUp(sheet.Reversed(), 0.005)}));
  EXPECT_EQ(model.edgeCount(), 8);
  expectSound(mesh(model, 2), 200);
}

/// Those of parts that touch have edges at the same places.
TEST(Dirt, PartsThatTouchStayApartWhenTheirFacesAreSewn) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(1, 1, 1).Shape();
  gp_Trsf beside;
  beside.SetTranslation({1, 0, 0});
  const Model model = throughIges(testing::compoundOf({block, block.Moved(beside)}));
  EXPECT_EQ(model.faceCount(), 12);
  EXPECT_EQ(model.edgeCount(), 24);
  const ModelMesh result = mesh(model, 0.3);
  expectSound(result, 12);
  expectClosed(result);
}

TEST(Dirt, PlacedAndMirroredInstancesLookOutwards) {
  const TopoDS_Shape block = drilledBlock(1);
  gp_Trsf placed, mirrored;
  placed.SetRotation(gp_Ax1({0, 0, 0}, gp_Dir(1, 2, 3)), 1);
  placed.SetTranslationPart({10, 0, 0});
  mirrored.SetMirror(gp_Ax2({-2, 0, 0}, {1, 0, 0}));
  const TopoDS_Shape mirrorImage = BRepBuilderAPI_Transform(block, mirrored, true).Shape();
  for (const TopoDS_Shape& one : {block.Moved(placed), block.Moved(mirrored, false), mirrorImage})
    EXPECT_NEAR(volumeOf(mesh(one, 0.4)), kBlockVolume, 0.05);
  const ModelMesh result = mesh(
      testing::compoundOf({block, block.Moved(placed), block.Moved(mirrored, false), mirrorImage}),
      0.4);
  expectSound(result, 4 * kBlockArea, 0.02);
  expectClosed(result);
  EXPECT_NEAR(volumeOf(result), 4 * kBlockVolume, 0.1);
}

TEST(Dirt, ASheetIsMeshedWithItsBorders) {
  const TopExp_Explorer first(BRepPrimAPI_MakeBox(1, 1, 1).Shape(), TopAbs_FACE);
  expectSound(mesh(first.Current(), 0.3), 1);
}

TEST(Dirt, AFaceBetweenTwoSolidsIsMeshedOnce) {
  const ModelMesh result = mesh(testing::sharedFace(), 0.3);
  EXPECT_EQ(result.faces.size(), 11u);
  expectSound(result, 11);
  const auto shared = std::ranges::count(result.segments, 3, &EdgeSegment::uses);
  EXPECT_GE(shared, 4 * 3);
}

TEST(Dirt, WhateverACompoundHoldsIsMeshed) {
  TopExp_Explorer shell(BRepPrimAPI_MakeBox(gp_Pnt(5, 0, 0), 1, 1, 1).Shape(), TopAbs_SHELL);
  const TopoDS_Compound inner =
      testing::compoundOf({shell.Current(), testing::polygon({{9, 0, 0}, {11, 0, 0}, {9, 1, 0}})});
  const ModelMesh result = mesh(
      testing::compoundOf({inner, BRepPrimAPI_MakeBox(1, 1, 1).Shape(), testing::compoundOf({})}),
      0.4);
  expectSound(result, 13);
}

TEST(Dirt, AFaceThatIsTurnedIsMeshedAsItLies) {
  const ModelMesh result = mesh(testing::turnedFace(), 0.3);
  expectSound(result, 6);
  EXPECT_GT(std::abs(volumeOf(result) - volumeOf(result, {5, 5, 5})), 1);  // not that of a solid
}

TEST(Dirt, TinyStepsAreKept) {
  for (const double tiny : {1e-2, 4e-4}) {
    SCOPED_TRACE(tiny);
    const ModelMesh result = mesh(testing::tinyStep(tiny), 0.3);
    expectSound(result, 6, 0.02);
    expectClosed(result);
    EXPECT_NEAR(volumeOf(result), 1 - tiny / 2, 1e-7);
  }
}

/// The step has no width, but those above and below it share its edge, so the mesh is closed.
TEST(Dirt, AStepThatCannotBeSeenIsNone) {
  for (const double tiny : {1e-6, 6e-5, 2.9e-4}) {
    SCOPED_TRACE(tiny);
    const ModelMesh result = mesh(testing::tinyStep(tiny), 0.3);
    expectSound(result, 6, 1e-3);
    EXPECT_EQ(testing::eulerNumber(result), 2);
    EXPECT_EQ(std::ranges::count(result.faces, 0u, &FaceReport::elements), 1);
    const auto isTold = [](const FaceReport& face) {
      return !face.attempts.empty() &&
             face.attempts[0].find("collapsed to points") != std::string::npos;
    };
    EXPECT_GE(std::ranges::count_if(result.faces, isTold), 3);  // the step, and those at its ends
    EXPECT_GT(testing::leastAngle(result), 10);
  }
}

/// Its sides are as narrow as a step that is closed, but the faces beyond them would coincide.
TEST(Dirt, APlateIsNotClosedForBeingThin) {
  const ModelMesh result = mesh(BRepPrimAPI_MakeBox(1, 1, 6e-5).Shape(), 0.25);
  expectSound(result, 2 + 2.4e-4);
  EXPECT_NEAR(volumeOf(result), 6e-5, 1e-12);
}

TEST(Dirt, AStepInTheOutlineOfASheetIsKept) {
  const double tiny = 6e-5;
  const TopoDS_Face sheet = testing::polygon(
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, 1, 0}, {0.5, 1 - tiny, 0}, {0, 1 - tiny, 0}});
  const ModelMesh result = mesh(sheet, 0.3);
  testing::expectComplete(result);
  EXPECT_NEAR(areaOf(result), 1 - tiny / 2, 1e-9);
}

/// Nor is a strip that is all there is, unless it cannot be seen.
TEST(Dirt, AStripAloneIsClosedOnlyWhereItCannotBeSeen) {
  const TopoDS_Face strip = testing::polygon({{0, 0, 0}, {1, 0, 0}, {1, 3e-5, 0}, {0, 3e-5, 0}});
  const ModelMesh seen = mesh(strip, 0.25), unseen = mesh(strip, 1);
  testing::expectComplete(seen);
  EXPECT_NEAR(areaOf(seen), 3e-5, 1e-12);
  EXPECT_TRUE(unseen.elements.empty());
  EXPECT_NE(unseen.faces[0].reason.find("ask for a smaller one"), std::string::npos);
}

TEST(Dirt, ShortEdgesThatAreGivenAreKept) {
  const Model model = testing::modelOf(testing::tinyStep(1e-6));
  MeshingOptions options = testing::ofSize(0.3);
  for (int edge = 1; edge <= model.edgeCount(); ++edge) {
    const auto [from, to] = testing::endsOf(model, edge);
    if (distance(from, to) < 1e-5) options.edgePoints[edge] = {};
  }
  ASSERT_EQ(options.edgePoints.size(), 2u);
  const ModelMesh result = mesh(model, options);
  for (const auto& [edge, points] : options.edgePoints)
    EXPECT_EQ(std::ranges::count(result.segments, edge, &EdgeSegment::edge), 1);
}

/// Each of its sides is too short to be seen, but not all of them.
TEST(Dirt, AHoleOfManyShortSidesStaysAHole) {
  std::vector<gp_Pnt> corners;
  for (int i = 0; i < 100; ++i)
    corners.push_back(
        {1 + 1e-3 * std::cos(-2 * pi * i / 100), 1 + 1e-3 * std::sin(-2 * pi * i / 100), 0});
  const ModelMesh result = mesh(testing::plateWithHole(2, corners), 2);
  testing::expectComplete(result);
  EXPECT_NEAR(areaOf(result), 4 - pi * 1e-6, 1e-6);
  EXPECT_LT(areaOf(result), 4 - 2e-6);
}

TEST(Dirt, AThinPlateKeepsItsSliversOnTheSides) {
  const ModelMesh result = mesh(BRepPrimAPI_MakeBox(1, 1, 1e-2).Shape(), 0.25);
  expectSound(result, 2 + 4e-2);
  EXPECT_NEAR(volumeOf(result), 1e-2, 1e-12);
}

/// A pad on a block, or a pocket in it, that is too flat to be seen.
TEST(Dirt, AStepAroundAPadIsClosed) {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(4, 4, 2).Shape();
  const TopoDS_Shape pad = BRepPrimAPI_MakeBox({1, 1, 1}, {3, 3, 2.0008}).Shape();
  const TopoDS_Shape pocket = BRepPrimAPI_MakeBox({1, 1, 1.9992}, {3, 3, 3}).Shape();
  for (const TopoDS_Shape& shape :
       {BRepAlgoAPI_Fuse(block, pad).Shape(), BRepAlgoAPI_Cut(block, pocket).Shape()}) {
    const ModelMesh result = mesh(shape, 1);
    expectSound(result, 64, 1e-3);
    EXPECT_EQ(testing::eulerNumber(result), 2);
    EXPECT_LT(result.elements.size(), 300u);
  }
}

/// It is not known whether the faces beyond the step would fold then.
TEST(Dirt, AStepBesideAFaceWithoutASurfaceStays) {
  const BRep_Builder builder;
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(4, 4, 2).Shape();
  const TopoDS_Shape pad = BRepPrimAPI_MakeBox({1, 1, 1}, {3, 3, 2.0008}).Shape();
  TopoDS_Compound faces;
  builder.MakeCompound(faces);
  for (TopExp_Explorer it(BRepAlgoAPI_Fuse(block, pad).Shape(), TopAbs_FACE); it.More();
       it.Next()) {
    TopoDS_Face face = TopoDS::Face(it.Current());
    Bnd_Box box;
    BRepBndLib::Add(face, box);
    if (box.CornerMin().Z() > 2.0005) {  // the top of the pad
      const TopoDS_Face top = face;
      face.Nullify();
      builder.MakeFace(face);
      for (TopoDS_Iterator wire(top); wire.More(); wire.Next()) builder.Add(face, wire.Value());
    }
    builder.Add(faces, face);
  }
  const ModelMesh result = mesh(faces, 1);
  EXPECT_EQ(failedFaces(result), 1u);
  EXPECT_NEAR(areaOf(result), 60, 0.01);
}

/// Its sides would fall together.
TEST(Dirt, AStepThatIsAPlateIsNot) {
  const ModelMesh result = mesh(BRepPrimAPI_MakeBox(0.1, 0.1, 8e-5).Shape(), 0.1);
  expectSound(result, 2e-2 + 4 * 0.1 * 8e-5);
  EXPECT_NEAR(volumeOf(result), 8e-7, 1e-12);
}

TEST(Dirt, EdgesGetTheirCurvesFromTheFace) {
  const Model model = testing::modelOf(testing::withoutCurves());
  EXPECT_FALSE(model.notes().empty());
  expectSound(mesh(model, 0.1), pi / 2, 0.01);
}

TEST(Dirt, ALoopMayTouchItself) { expectSound(mesh(testing::touchingLoop(), 0.3), 2); }

TEST(Dirt, AFaceThatCannotBeMeshedIsNamedAndLeavesTheOthersAlone) {
  for (const TopoDS_Face& bad : {testing::crossingLoop(), testing::openLoop(), TopoDS_Face()}) {
    const TopoDS_Shape box = BRepPrimAPI_MakeBox(gp_Pnt(5, 0, 0), 1, 1, 1).Shape();
    TopoDS_Face face = bad;
    if (face.IsNull()) BRep_Builder().MakeFace(face);  // without a surface
    const ModelMesh result = mesh(testing::compoundOf({face, box}), 0.3);
    ASSERT_EQ(result.faces.size(), 7u);
    EXPECT_EQ(result.faces[0].status, FaceStatus::Failed);
    EXPECT_FALSE(result.faces[0].reason.empty());
    for (std::size_t i = 1; i < 7; ++i) EXPECT_EQ(result.faces[i].status, FaceStatus::Complete);
    EXPECT_NEAR(areaOf(result), 6, 1e-9);
  }
}

}  // namespace
}  // namespace af2::geometry
