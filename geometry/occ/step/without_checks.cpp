#include "geometry/occ/step/without_checks.h"

#include <Interface_GeneralLib.hxx>
#include <RWStepAP214_GeneralModule.hxx>
#include <StepAP214.hxx>
#include <StepAP214_Protocol.hxx>
#include <typeinfo>

namespace af2::geometry {
namespace {

class Unchecked final : public RWStepAP214_GeneralModule {
 public:
  void CheckCase(const Standard_Integer, const Handle(Standard_Transient) &,
                 const Interface_ShareTool&, Handle(Interface_Check) &) const override {}
};

/// What knows the entities of STEP files; null: nothing, or not what OpenCASCADE has.
Handle(Interface_GeneralModule) known() {
  Interface_GeneralLib modules(StepAP214::Protocol());
  for (modules.Start(); modules.More(); modules.Next())
    if (modules.Protocol() == StepAP214::Protocol() &&
        typeid(*modules.Module()) == typeid(RWStepAP214_GeneralModule))
      return modules.Module();
  return {};
}

}  // namespace

WithoutChecks::WithoutChecks() : before_(known()) {
  if (!before_.IsNull()) Interface_GeneralLib::SetGlobal(new Unchecked, StepAP214::Protocol());
}

WithoutChecks::~WithoutChecks() {
  if (!before_.IsNull()) Interface_GeneralLib::SetGlobal(before_, StepAP214::Protocol());
}

}  // namespace af2::geometry
