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
                              const std::filesystem::path& path, const StepDocument& document) {
  ExternalParts parts;
  std::set<std::filesystem::path> reported;
  std::vector<std::filesystem::path> paths;  // of the sessions
  const auto lookAt = [&](const Handle(XSControl_WorkSession) & from,
                          const std::filesystem::path& file) {
    STEPConstruct_ExternRefs references(from);
    if (!references.LoadExternRefs()) return;
    for (int i = 1; i <= references.NbExternRefs(); ++i) {
      const char* const text = references.FileName(i);
      const std::string name = text ? text : "";
      const std::filesystem::path place = besideStepFile(file, name);
      const Handle(XSControl_WorkSession) other = document.sessionOf(place);
      const bool isRead = !other.IsNull();
      if (!isRead && hasFaces(from, references.ProdDef(i))) continue;
      if (!reported.insert(place).second) continue;
      (isRead ? parts.read : parts.missing).push_back(name);
      if (!isRead) continue;
      parts.sessions.push_back(other);
      paths.push_back(place);
    }
  };
  lookAt(session, path);
  // Grows as it goes on: parts may be assemblies again.
  for (std::size_t i = 0; i < paths.size(); ++i)
    lookAt(Handle(XSControl_WorkSession)(parts.sessions[i]), std::filesystem::path(paths[i]));
  return parts;
}

}  // namespace af2::geometry
