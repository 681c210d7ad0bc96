// STEP assemblies with parts in files of their own.
#include <gtest/gtest.h>

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>

#include "engine/base/error.h"
#include "geometry/base/words.h"
#include "geometry/occ/model/model.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

namespace fs = std::filesystem;

/// A folder of its own, which ends with the test.
class ExternalParts : public ::testing::Test {
 protected:
  /// A plate and a bolt that is there twice; with a prefix, each part in a file of its own.
  fs::path writeMachine(const char* prefix, const std::string& folder = "",
                        double length = 20) const {
    fs::create_directories(folder_ / folder);
    const Handle(TDocStd_Document) document = new TDocStd_Document("XmlXCAF");
    const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
    const TDF_Label plate = shapes->AddShape(BRepPrimAPI_MakeBox(length, 10, 2).Shape(), false);
    const TDF_Label bolt = shapes->AddShape(BRepPrimAPI_MakeCylinder(1, 4).Shape(), false);
    TDataStd_Name::Set(plate, "plate");
    TDataStd_Name::Set(bolt, "bolt");
    const TDF_Label machine = shapes->NewShape();
    TDataStd_Name::Set(machine, "machine");
    shapes->AddComponent(machine, plate, TopLoc_Location());
    for (const double x : {length / 4, 3 * length / 4}) {
      gp_Trsf place;
      place.SetTranslation({x, 5, 2});
      shapes->AddComponent(machine, bolt, TopLoc_Location(place));
    }
    shapes->UpdateAssemblies();
    Message::DefaultMessenger()->ChangePrinters().Clear();
    STEPCAFControl_Writer writer;
    writer.Transfer(document, STEPControl_AsIs, prefix);
    const fs::path path = folder_ / folder / "machine.step";
    writer.Write(path.c_str());
    return path;
  }

  const testing::TestFolder folder_;
};

std::vector<int> facesOf(const Model& model, const std::string& part) {
  for (const FaceGroup& group : model.groups())
    if (group.name == part) return group.faces;
  return {};
}

TEST_F(ExternalParts, AreReadFromTheFilesBesideTheAssembly) {
  const Model model = readModel(writeMachine("part_"));
  EXPECT_EQ(model.faceCount(), 12);
  EXPECT_NEAR(model.diagonal(), std::sqrt(20 * 20 + 10 * 10 + 6 * 6), 1e-3);
  EXPECT_EQ(facesOf(model, "machine").size(), 12u);
  EXPECT_EQ(facesOf(model, "plate").size(), 6u);
  EXPECT_EQ(facesOf(model, "bolt").size(), 6u);
  ASSERT_EQ(model.notes().size(), 1u);
  EXPECT_NE(model.notes()[0].find("'part_bolt.stp'"), std::string::npos) << model.notes()[0];
}

TEST_F(ExternalParts, AreFoundByARelativePath) {
  const fs::path whole = writeMachine("part_");
  EXPECT_EQ(readModel(fs::relative(whole)).faceCount(), 12);
}

TEST_F(ExternalParts, AreNamedIfTheyAreMissing) {
  const fs::path assembly = writeMachine("part_");
  ASSERT_TRUE(fs::remove(folder_ / "part_bolt.stp"));
  try {
    readModel(assembly);
    FAIL() << "was read without its bolts";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("'part_bolt.stp'"), std::string::npos) << text;
    EXPECT_EQ(text.find("'part_plate.stp'"), std::string::npos) << text;
  }
}

/// Replaces all that is a text in a file.
void replace(const fs::path& file, const std::string& from, const std::string& to) {
  std::string text = contentOf(file);
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  std::ofstream(file) << text;
}

TEST_F(ExternalParts, MayHaveTheSameNameInOtherFolders) {
  const fs::path top = writeMachine("part_");
  writeMachine("part_", "short");
  writeMachine("part_", "long", 40);
  replace(top, "part_plate.stp", "short/machine.step");
  replace(top, "part_bolt.stp", "long/machine.step");
  const Model model = readModel(top);
  // The short machine, and the long one in the places of both bolts.
  EXPECT_EQ(model.faceCount(), 3 * 12);
  EXPECT_EQ(facesOf(model, "plate").size(), 12u + 2 * 6);
  EXPECT_EQ(facesOf(model, "bolt").size(), 2 * 12u + 6);
  EXPECT_NEAR(model.diagonal(), std::sqrt(55 * 55 + 15 * 15 + 8 * 8), 1e-3);
}

/// Gives the first product of a file another file that describes it.
void refer(const fs::path& from, const std::string& to) {
  std::string text = contentOf(from);
  const std::size_t definition = text.find(" = PRODUCT_DEFINITION(");
  ASSERT_NE(definition, std::string::npos);
  const std::size_t number = text.rfind('#', definition);
  const std::string product = text.substr(number, definition - number);
  text.insert(text.rfind("ENDSEC;"),
              "#9001=DOCUMENT_FILE('" + to +
                  "','',$,#9002,'',$);\n"
                  "#9002=DOCUMENT_TYPE('');\n"
                  "#9003=APPLIED_EXTERNAL_IDENTIFICATION_ASSIGNMENT('" +
                  to +
                  "',#9004,#9005,(#9001));\n"
                  "#9004=IDENTIFICATION_ROLE('external document id and location',$);\n"
                  "#9005=EXTERNAL_SOURCE(IDENTIFIER('" +
                  to +
                  "'));\n"
                  "#9006=APPLIED_DOCUMENT_REFERENCE(#9001,'',(" +
                  product + "));\n");
  std::ofstream(from) << text;
}

TEST_F(ExternalParts, NeedNotBeThereIfTheAssemblyHasThemItself) {
  const fs::path assembly = writeMachine(nullptr);
  refer(assembly, "drawing.stp");
  const Model model = readModel(assembly);
  EXPECT_EQ(model.faceCount(), 12);
  EXPECT_TRUE(model.notes().empty());
}

/// Of products the name, else the number; of uses the description, else the name.
TEST_F(ExternalParts, HaveTheNamesThatTheFileGivesThem) {
  const fs::path assembly = writeMachine(nullptr);
  replace(assembly, "PRODUCT('plate','plate'", "PRODUCT('P-17','cover'");
  replace(assembly, "PRODUCT('bolt','bolt'", "PRODUCT('B-4',''");
  // The writer counts uses, from file to file, and makes names up.
  std::string text = contentOf(assembly);
  for (const char* const use :
       {"('1','','',", "('2','first','left bolt',", "('3','right bolt','',"}) {
    const std::regex unnamed("(_USAGE_OCCURRENCE)\\('[^']*','[^']*','[^']*',");
    text = std::regex_replace(text, unnamed, std::string("$1 ") + use,
                              std::regex_constants::format_first_only);
  }
  std::ofstream(assembly) << text;
  const Model model = readModel(assembly);
  const std::vector<std::pair<const char*, std::size_t>> expected{
      {"machine", 12}, {"cover", 6}, {"B-4", 6},  {"left bolt", 3}, {"right bolt", 3},
      {"P-17", 0},     {"plate", 0}, {"bolt", 0}, {"first", 0}};
  for (const auto& [name, faces] : expected) EXPECT_EQ(facesOf(model, name).size(), faces) << name;
}

TEST_F(ExternalParts, AreNotReadIfTheAssemblyHasThemItself) {
  const fs::path assembly = writeMachine(nullptr);
  writeMachine(nullptr, "other", 40);
  refer(assembly, "other/machine.step");
  const Model model = readModel(assembly);
  EXPECT_EQ(model.faceCount(), 12);
  EXPECT_TRUE(model.notes().empty());
}

TEST_F(ExternalParts, MayReferToTheAssembly) {
  const fs::path assembly = writeMachine("part_");
  refer(folder_ / "part_bolt.stp", "machine.step");
  const Model model = readModel(assembly);
  EXPECT_EQ(model.faceCount(), 12);
  EXPECT_EQ(facesOf(model, "bolt").size(), 6u);
}

}  // namespace
}  // namespace af2::geometry
