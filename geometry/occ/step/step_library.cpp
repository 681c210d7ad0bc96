#include "geometry/occ/step/step_library.h"

#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepReaderData.hxx>
#include <StepData_StepReaderTool.hxx>
#include <array>
#include <limits>
#include <sstream>

#include "geometry/occ/step/step_records.h"

namespace af2::geometry {

namespace {

/// In the order of StepKind.
constexpr std::array kTypes{Interface_ParamSub,  Interface_ParamIdent, Interface_ParamInteger,
                            Interface_ParamReal, Interface_ParamEnum,  Interface_ParamText,
                            Interface_ParamVoid, Interface_ParamMisc};

/// It refers to the words of the records.
Handle(StepData_StepReaderData) dataOf(StepRecords& records, Resource_FormatType codePage) {
  const Handle(StepData_StepReaderData) data = new StepData_StepReaderData(
      static_cast<int>(records.headCount()), static_cast<int>(records.count()),
      static_cast<int>(records.valueCount()), codePage);
  int number = 0;
  records.forEach([&](const StepRecord& record) {
    data->SetRecord(++number, record.label.data(), record.type.data(),
                    static_cast<int>(record.values.size()));
    for (const StepValue& value : record.values)
      data->AddStepParam(number, value.word.data(), kTypes[static_cast<std::size_t>(value.kind)]);
    data->InitParams(number);
  });
  return data;
}

}  // namespace

Standard_Integer StepLibrary::ReadFile(Standard_CString name,
                                       Handle(Interface_InterfaceModel) & model,
                                       const Handle(Interface_Protocol) & protocol) const {
  StepRecords records(text_);
  if (!records.arePlain()) {
    std::istringstream stream(text_);
    return ReadStream(name, stream, model, protocol);
  }
  const auto known = Handle(StepData_Protocol)::DownCast(protocol);
  if (known.IsNull()) return 1;
  const Handle(StepData_StepModel) entities = new StepData_StepModel;
  model = entities;
  StepData_StepReaderTool tool(dataOf(records, entities->SourceCodePage()), known);
  tool.SetErrorHandle(true);
  const Handle(StepData_FileRecognizer) none;
  tool.PrepareHeader(none);
  tool.Prepare(none);
  tool.LoadModel(entities);
  if (entities->Protocol().IsNull()) entities->SetProtocol(known);
  tool.Clear();
  return 0;
}

}  // namespace af2::geometry
