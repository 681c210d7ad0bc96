// That entities of STEP files are not checked, and that OpenCASCADE checks them again later.
#include "geometry/occ/step/without_checks.h"

#include <gtest/gtest.h>
#include <BRepPrimAPI_MakeBox.hxx>
#include <Interface_Check.hxx>
#include <Interface_GeneralLib.hxx>
#include <Interface_ShareTool.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <StepAP214.hxx>
#include <StepAP214_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <string>

#include "geometry/occ/model/model.h"
#include "tests/geometry/occ/in_step.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

/// A file with an edge that runs the same way in two faces.
std::string twistedBox() {
  std::string text = testing::inStep(BRepPrimAPI_MakeBox(1, 2, 3).Solid());
  const std::size_t way = text.find('.', text.find("ORIENTED_EDGE"));
  char& isForward = text.at(way + 1);
  isForward = isForward == 'T' ? 'F' : 'T';
  return text;
}

/// How many entities OpenCASCADE would complain about.
int complaintsAbout(const testing::TestFile& file) {
  STEPControl_Reader reader;
  EXPECT_EQ(reader.ReadFile(file.path().c_str()), IFSelect_RetDone);
  const Handle(StepData_StepModel) model = reader.StepModel();
  const Interface_GeneralLib modules(StepAP214::Protocol());
  const Interface_ShareTool sharing(model, StepAP214::Protocol());
  int count = 0;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(Standard_Transient) entity = model->Value(i);
    Handle(Interface_GeneralModule) module;
    int kind = 0;
    if (!modules.Select(entity, module, kind)) continue;
    Handle(Interface_Check) check = new Interface_Check(entity);
    module->CheckCase(kind, entity, sharing, check);
    count += check->HasFailed() || check->HasWarnings();
  }
  return count;
}

TEST(WithoutChecks, NothingIsSaidOfEdges) {
  const testing::TestFile file("twisted.step", twistedBox());
  const int before = complaintsAbout(file);
  EXPECT_GT(before, 0);
  {
    const WithoutChecks unchecked;
    EXPECT_EQ(complaintsAbout(file), 0);
  }
  EXPECT_EQ(complaintsAbout(file), before);
}

TEST(WithoutChecks, TheReaderLeavesEverythingAsItWas) {
  const testing::TestFile file("twisted.step", twistedBox());
  const int before = complaintsAbout(file);
  Interface_Static::SetRVal("read.encoderegularity.angle", 0.02);
  EXPECT_EQ(readModel(file.path()).faceCount(), 6);
  EXPECT_EQ(Interface_Static::RVal("read.encoderegularity.angle"), 0.02);
  Interface_Static::SetRVal("read.encoderegularity.angle", 0.01);
  EXPECT_EQ(complaintsAbout(file), before);
}

}  // namespace
}  // namespace af2::geometry
