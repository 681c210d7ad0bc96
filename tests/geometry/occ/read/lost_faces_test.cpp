// Faces of a file that no reader can make anything of.
#include <gtest/gtest.h>

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <algorithm>
#include <filesystem>

#include "geometry/base/words.h"
#include "geometry/io/report.h"
#include "geometry/occ/heal/heal_model.h"
#include "geometry/occ/run/mesh_model.h"
#include "tests/geometry/occ/in_iges.h"
#include "tests/geometry/occ/in_step.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

void replace(std::string& text, const std::string& what, const std::string& by) {
  const std::size_t place = text.find(what);
  ASSERT_NE(place, std::string::npos) << what;
  text.replace(place, what.size(), by);
}

Model read(const std::string& name, const std::string& text) {
  return readModel(testing::TestFile(name, text).path());
}

/// The cylinder of the examples, the surface of which is of a kind that does not exist.
Model withoutMantle() {
  std::string text = contentOf(AF2_SOURCE_DIR
                               "/examples/models"
                               "/cylinder.step");
  replace(text, "CYLINDRICAL_SURFACE(", "SPIRAL_SURFACE(");
  return read("lost.step", text);
}

TEST(LostFaces, OfAStepFileAreNamed) {
  const Model model = withoutMantle();
  EXPECT_EQ(model.faceCount(), 2);
  ASSERT_EQ(model.lostFaces().size(), 1u);
  EXPECT_EQ(model.lostFaces()[0][0], '#');
  EXPECT_TRUE(readModel(AF2_SOURCE_DIR "/examples/models"
                                       "/cylinder.step")
                  .lostFaces()
                  .empty());
}

TEST(LostFaces, AreNoCompleteMesh) {
  const ModelMesh mesh = testing::mesh(withoutMantle(), 0.5);
  ASSERT_EQ(mesh.findings.size(), 1u);
  EXPECT_NE(mesh.findings[0].find("could not be read"), std::string::npos) << mesh.findings[0];
}

TEST(LostFaces, DoNotMatterToThoseWhoAskForOthers) {
  MeshingOptions options = testing::ofSize(0.5);
  options.faces = {1};
  EXPECT_TRUE(testing::mesh(withoutMantle(), options).findings.empty());
}

TEST(LostFaces, AreLostAfterHealing) {
  EXPECT_EQ(healModel(withoutMantle(), {}).lostFaces().size(), 1u);
}

/// The brick with a hole, with another number in the place of one coordinate of a corner of it.
std::string brickWith(const std::string& number) {
  std::string text = contentOf(AF2_SOURCE_DIR
                               "/examples/models"
                               "/brickhole.step");
  replace(text, "#25 = CARTESIAN_POINT('',(0.,0.,10.))",
          "#25 = CARTESIAN_POINT('#25=1.E+999',(0.,0.," + number + ")) /* #26=1.E+999 */");
  return text;
}

TEST(LostFaces, OfAStepFileAreThoseThatDependOnWhatIsNoNumber) {
  EXPECT_TRUE(read("sound.step", brickWith("10")).lostFaces().empty());
  for (const std::string number :
       {"nan", "NAN", "inf", "$", "*", "'10.'", "", "(10.)", "-1.#IND", "1.E400", "-1.E+300"}) {
    const Model model = read("number.step", brickWith(number));
    EXPECT_EQ(model.faceCount(), 7) << number;
    EXPECT_EQ(model.lostFaces().size(), 3u) << number;
    ASSERT_FALSE(model.notes().empty()) << number;
    EXPECT_NE(model.notes()[0].find("#25: "), std::string::npos) << model.notes()[0];
  }
}

TEST(LostFaces, OfAStepFileAreThoseWhoseBoundaryIsLost) {
  std::string text = contentOf(AF2_SOURCE_DIR
                               "/examples/models"
                               "/brickhole.step");
  replace(text, "FACE_BOUND('',", "FACE_BOUNT('',");
  const Model model = read("bound.step", text);
  EXPECT_EQ(model.faceCount(), 9);
  EXPECT_EQ(model.lostFaces().size(), 1u);
}

TEST(LostFaces, OfAStepFileTellWhatIsWrongWithThem) {
  const Model model = read("number.step", brickWith("nan"));
  for (const std::string& face : model.lostFaces())
    EXPECT_NE(face.find("(#25: "), std::string::npos) << face;
}

/// A cylinder of rational splines, which are complex entities.
std::string rationalInStep() {
  return testing::inStep(
      BRepBuilderAPI_NurbsConvert(BRepPrimAPI_MakeCylinder(2, 5).Shape()).Shape());
}

/// OpenCASCADE does not read an entity that leaves its name out.
TEST(LostFaces, AreNoneWhereOnlyANameIsLeftOut) {
  std::string text = rationalInStep();
  const ModelMesh sound = testing::mesh(read("rational.step", text), 1);
  testing::expectComplete(sound);
  replace(text, " REPRESENTATION_ITEM('') SURFACE", " REPRESENTATION_ITEM( ) SURFACE");
  const Model model = read("rational.step", text);
  EXPECT_TRUE(model.lostFaces().empty());
  EXPECT_TRUE(model.notes().empty());
  EXPECT_EQ(testing::mesh(model, 1).vertices, sound.vertices);
}

/// Scripts write reals like this.
TEST(LostFaces, AreNoneWhereExponentsHaveSmallLetters) {
  std::string text = testing::inStep(BRepPrimAPI_MakeBox(10, 20, 30).Shape());
  const ModelMesh sound = testing::mesh(read("sound.step", text), 5);
  replace(text, "CARTESIAN_POINT('',(10.,0.,0.))", "CARTESIAN_POINT('1e1',(1e1,-0.0e-17,.0e+3))");
  const std::string name = "Open CASCADE STEP translator";
  while (text.find(name) != std::string::npos) replace(text, name, "3e4 brick");
  const Model model = read("exponents.step", text);
  EXPECT_EQ(model.faceCount(), 6);
  EXPECT_TRUE(model.lostFaces().empty());
  EXPECT_TRUE(model.notes().empty());
  EXPECT_EQ(testing::mesh(model, 5).vertices, sound.vertices);
  const auto named = [](const FaceGroup& group) {
    return group.name.find("3e4 brick") != std::string::npos;
  };
  EXPECT_TRUE(std::ranges::any_of(model.groups(), named));
}

/// Plain faces that share no edges, as IGES has them.
std::string boxInIges() { return testing::inIges({BRepPrimAPI_MakeBox(10, 20, 30).Shape()}); }

TEST(LostFaces, OfAnIgesFileAreNamed) {
  std::string text = boxInIges();
  replace(text, "144,5,1,0,", "144,7,1,0,");  // its surface is a curve
  const Model model = read("box.igs", text);
  EXPECT_EQ(model.faceCount(), 5);
  EXPECT_EQ(model.lostFaces(), std::vector<std::string>{"D3"});
  EXPECT_FALSE(testing::mesh(model, 5).findings.empty());
}

TEST(LostFaces, OfAnIgesFileDoNotVanishWhenTheOthersAreSewn) {
  std::string text = boxInIges();
  EXPECT_EQ(read("box.igs", text).faceCount(), 6);
  EXPECT_TRUE(read("box.igs", text).lostFaces().empty());
  // A side of one face ends in the wrong place, so that its loop cannot close.
  replace(text, "110,10.,0.,30.,10.,20.,30.;", "110,10.,0.,30.,10.,20.,99.;");
  const Model model = read("box.igs", text);
  EXPECT_EQ(static_cast<std::size_t>(model.faceCount()) + model.lostFaces().size(), 6u);
  const ModelMesh mesh = testing::mesh(model, 5);
  EXPECT_TRUE(statusOf(mesh) != RunStatus::Complete || !mesh.findings.empty());
  // Nor when healing takes it for a spot.
  const Model healed = healModel(model, {});
  EXPECT_EQ(static_cast<std::size_t>(healed.faceCount()) + healed.lostFaces().size(), 6u);
}

}  // namespace
}  // namespace af2::geometry
