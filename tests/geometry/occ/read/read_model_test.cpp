#include <gtest/gtest.h>
#include <BRepPrimAPI_MakeBox.hxx>
#include <Interface_Static.hxx>
#include <filesystem>
#include <fstream>
#include <map>

#include "engine/base/error.h"
#include "geometry/base/words.h"
#include "geometry/occ/model/model.h"
#include "tests/geometry/occ/in_iges.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

namespace fs = std::filesystem;
const fs::path kModels = AF2_SOURCE_DIR "/examples/models";

/// A folder for the files of one test.
class ReadModel : public ::testing::Test {
 protected:
  fs::path file(const std::string& name, const std::string& text) const {
    return folder_.write(name, text);
  }
  static std::string messageOf(const fs::path& path) {
    try {
      readModel(path);
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find(path.string()), 0u) << "does not name the file";
      return error.what();
    }
    return "no error";
  }
  static bool says(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

  testing::TestFolder folder_;
};

TEST_F(ReadModel, ReadsStepAndBrepAlike) {
  for (const std::string name : {"brickhole", "cylinder", "die"}) {
    const Model step = readModel(kModels / (name + ".step"));
    const Model brep = readModel(kModels / (name + ".brep"));
    EXPECT_EQ(step.faceCount(), brep.faceCount());
    EXPECT_EQ(step.edgeCount(), brep.edgeCount());
    EXPECT_NEAR(step.diagonal(), brep.diagonal(), 1e-6 * brep.diagonal());
    EXPECT_EQ(step.unit(), "mm");
    EXPECT_EQ(brep.unit(), "");
  }
}

TEST_F(ReadModel, LeavesTheSettingsOfOtherReadersAlone) {
  const testing::TestFile iges("box.igs", testing::inIges({BRepPrimAPI_MakeBox(1, 2, 3).Shape()}));
  readModel(kModels / "die.step");  // the settings are there from now on
  const std::map<std::string, std::string> own{{"xstep.cascade.unit", "INCH"},
                                               {"read.step.codepage", "GB"},
                                               {"read.surfacecurve.mode", "3DUse_Preferred"}};
  std::map<std::string, std::string> before, after;
  for (const auto& [name, value] : own) {
    before[name] = Interface_Static::CVal(name.c_str());
    Interface_Static::SetCVal(name.c_str(), value.c_str());
  }
  readModel(kModels / "die.step");
  readModel(iges.path());
  for (const auto& [name, value] : before) {
    after[name] = Interface_Static::CVal(name.c_str());
    Interface_Static::SetCVal(name.c_str(), value.c_str());
  }
  EXPECT_EQ(after, own);
}

TEST_F(ReadModel, GoesByTheContentNotTheName) {
  const fs::path path = file("model.txt", contentOf(kModels / "cylinder.step"));
  EXPECT_EQ(readModel(path).faceCount(), 3);
}

TEST_F(ReadModel, KnowsTheTypesOfSurfaces) {
  const Model model = readModel(kModels / "cylinder.step");
  std::vector<std::string> types;
  for (int id = 1; id <= 3; ++id) types.push_back(model.surfaceType(id));
  std::sort(types.begin(), types.end());
  EXPECT_EQ(types, (std::vector<std::string>{"cylinder", "plane", "plane"}));
}

TEST_F(ReadModel, SaysWhenThereIsNoFile) {
  EXPECT_TRUE(says(messageOf(folder_ / "none.step"), "there is no such file"));
  EXPECT_TRUE(says(messageOf(folder_.path()), "is a folder"));
}

TEST_F(ReadModel, SaysWhenTheFileIsEmptyOrSomethingElse) {
  EXPECT_TRUE(says(messageOf(file("a.step", "")), "is empty"));
  EXPECT_TRUE(says(messageOf(file("b.step", "hello\n")), "does not start like a STEP file"));
  EXPECT_TRUE(says(messageOf(file("c.brep", "\x01\x02\x03")), "does not start like a BREP file"));
  EXPECT_TRUE(says(messageOf(file("d.iges", "hello\n")), "does not start like an IGES file"));
  EXPECT_TRUE(says(messageOf(file("e.dat", "hello\n")), "is not a STEP, IGES or BREP file"));
}

TEST_F(ReadModel, SaysWhenTheFileIsCutOff) {
  for (const std::string name : {"cylinder.step", "cylinder.brep"}) {
    const std::string text = contentOf(kModels / name);
    for (const double share : {0.1, 0.5, 0.9, 0.99}) {
      const auto size = static_cast<std::size_t>(share * static_cast<double>(text.size()));
      EXPECT_TRUE(says(messageOf(file(name, text.substr(0, size))), "damaged or truncated"))
          << share;
    }
  }
}

TEST_F(ReadModel, SurvivesStepFilesThatReferToNothing) {
  std::string text = contentOf(kModels / "cylinder.step");
  // Without its vertices, OpenCASCADE's translator would dereference null.
  for (std::size_t at = text.find("VERTEX_POINT"); at != std::string::npos;
       at = text.find("VERTEX_POINT", at + 1))
    text.replace(at, 12, "VERTEX_PAINT");
  const fs::path path = file("cylinder.step", text);
  try {
    readModel(path);
  } catch (const InputError& error) {
    EXPECT_TRUE(says(error.what(), path.string()));
  }
}

}  // namespace
}  // namespace af2::geometry
