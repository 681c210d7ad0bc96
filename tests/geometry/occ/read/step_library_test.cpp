#include "geometry/occ/step/step_library.h"

#include <gtest/gtest.h>

#include <Interface_Check.hxx>
#include <Interface_ReportEntity.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "geometry/base/words.h"
#include "geometry/occ/model/model.h"
#include "geometry/occ/step/step_records.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

const std::string kText = contentOf(AF2_SOURCE_DIR "/examples/models/cylinder.step");

void add(const Handle(Interface_Check) & check, std::string& text) {
  for (int i = 1; i <= check->NbFails(); ++i) text.append("\n").append(check->CFail(i));
  for (int i = 1; i <= check->NbWarnings(); ++i) text.append("\n").append(check->CWarning(i));
}

/// The entities of a model as a file, their labels, and what was found wrong with them.
std::string contentOfModel(const Handle(StepData_StepModel) & model) {
  StepData_StepWriter writer(model);
  writer.SendModel(Handle(StepData_Protocol)::DownCast(model->Protocol()));
  std::ostringstream stream;
  writer.Print(stream);
  std::string text = stream.str();
  add(model->GlobalCheck(false), text);
  for (int i = 1; i <= model->NbEntities(); ++i) {
    text.append(" ").append(std::to_string(model->IdentLabel(model->Value(i))));
    if (model->IsReportEntity(i)) add(model->ReportEntity(i)->Check(), text);
  }
  return text;
}

std::string contentRead(const StepSelect_WorkLibrary& library, const testing::TestFile& file) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  const STEPControl_Reader reader;
  Handle(Interface_InterfaceModel) model;
  const int status = library.ReadFile(file.path().c_str(), model, reader.WS()->Protocol());
  const auto read = Handle(StepData_StepModel)::DownCast(model);
  return std::to_string(status) + (status == 0 ? contentOfModel(read) : "");
}

/// What OpenCASCADE reads, which must be what AF2 reads.
std::string contentReadOf(const std::string& text) {
  const testing::TestFile file("model.step", text);
  const std::string content = contentRead(StepSelect_WorkLibrary(), file);
  EXPECT_EQ(contentRead(StepLibrary(text), file), content) << text.substr(0, 1000);
  return content;
}

std::string replaced(std::string text, const std::string& by, const std::string& with) {
  return text.replace(text.find(by), by.size(), with);
}

TEST(StepLibrary, ReadsWhatOpenCascadeReads) {
  std::string text = kText;
  ASSERT_TRUE(StepRecords(text).arePlain());
  EXPECT_GT(contentReadOf(kText).size(), 1000u);
}

TEST(StepLibrary, ReadsFaultsAsOpenCascadeDoes) {
  const std::string face = "ADVANCED_FACE('',";
  const std::string plain = contentReadOf(kText);
  for (const std::string with :
       {"ADVANCED_FACE($,", "ADVANCED_FACE(*,", "ADVANCED_FACE(1.,", "ADVANCED_FACE(#99999999,",
        "UNKNOWN('',", "ADVANCED_FACE('','',", "ADVANCED_FACE(,", "ADVANCED_FACE('a'b',",
        "ADVANCED_FACE(NAME('a'),", "ADVANCED_FACE(('a','b'),"}) {
    const std::string text = replaced(kText, face, with);
    ASSERT_NE(text, kText);
    EXPECT_NE(contentReadOf(text), plain) << with;
  }
  contentReadOf(kText.substr(0, kText.size() / 2));
  contentReadOf("");
  contentReadOf("ISO-10303-21;");
}

/// Both of which OpenCASCADE refuses.
TEST(StepLibrary, ReadsByteOrderMarksAndLabelsInLinesOfTheirOwn) {
  for (const std::string& text : {"\xef\xbb\xbf" + kText, replaced(kText, "#1 =", "#1\n=")}) {
    ASSERT_NE(text, kText);
    const testing::TestFile file("cylinder.step", text);
    EXPECT_EQ(readModel(file.path()).faceCount(), 3);
  }
}

TEST(StepLibrary, ReadsWordsOfAnyLength) {
  const std::string name(100'000, 'n');
  const testing::TestFile file("cylinder.step",
                               replaced(kText, "ADVANCED_FACE('", "ADVANCED_FACE('" + name));
  const Model model = readModel(file.path());
  ASSERT_EQ(model.faceCount(), 3);
  std::vector<std::string> names;
  for (int id = 1; id <= model.faceCount(); ++id) names.push_back(model.faceName(id));
  EXPECT_EQ(std::ranges::count(names, name), 1);
}

}  // namespace
}  // namespace af2::geometry
