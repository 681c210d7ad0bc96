#include "geometry/occ/step/external_parts.h"

#include <STEPConstruct_ExternRefs.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>
#include <set>

namespace af2::geometry {

namespace {

/// A part may be in the assembly itself; then the other file is for information only.
bool hasFaces(const Handle(XSControl_WorkSession) & session,
              const Handle(StepBasic_ProductDefinition) & part) {
  const TopoDS_Shape shape =
      TransferBRep::ShapeResult(session->TransferReader()->TransientProcess(), part);
  return !shape.IsNull() && TopExp_Explorer(shape, TopAbs_FACE).More();
}

}  // namespace

ExternalParts externalPartsOf(const Handle(XSControl_WorkSession) & session,
                              const StepDocument& document) {
  ExternalParts parts;
  std::set<std::string> reported;
  const auto lookAt = [&](const Handle(XSControl_WorkSession) & from) {
    STEPConstruct_ExternRefs references(from);
    if (!references.LoadExternRefs()) return;
    for (int i = 1; i <= references.NbExternRefs(); ++i) {
      const char* const text = references.FileName(i);
      const std::string name = text ? text : "";
      const Handle(XSControl_WorkSession) file = document.fileOf(name);
      const bool isRead = !file.IsNull();
      if (!isRead && hasFaces(from, references.ProdDef(i))) continue;
      if (!reported.insert(name).second) continue;
      (isRead ? parts.read : parts.missing).push_back(name);
      if (isRead) parts.sessions.push_back(file);
    }
  };
  lookAt(session);
  // Grows as it goes on: parts may be assemblies again.
  for (std::size_t i = 0; i < parts.sessions.size(); ++i)
    lookAt(Handle(XSControl_WorkSession)(parts.sessions[i]));
  return parts;
}

}  // namespace af2::geometry
