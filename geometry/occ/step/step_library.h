// What reads the text of a STEP file for OpenCASCADE.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <StepSelect_WorkLibrary.hxx>
#include <string>

namespace af2::geometry {

/// Makes of a text the model of entities that OpenCASCADE makes of a file, with stepRecordsIn
/// in place of OpenCASCADE's parser, which takes several times as long (docs/performance.md).
/// OpenCASCADE's is used for texts that are not plain, as it can make something of faults.
class StepLibrary final : public StepSelect_WorkLibrary {
 public:
  explicit StepLibrary(std::string text) : text_(std::move(text)) {}

  /// name  of the file, for messages; it is not read
  Standard_Integer ReadFile(Standard_CString name, Handle(Interface_InterfaceModel) & model,
                            const Handle(Interface_Protocol) & protocol) const override;

 private:
  mutable std::string text_;  ///< the function that OpenCASCADE calls is constant
};

}  // namespace af2::geometry
