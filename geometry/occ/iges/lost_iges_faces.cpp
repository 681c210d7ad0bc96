#include "geometry/occ/iges/lost_iges_faces.h"

#include <IGESData_IGESEntity.hxx>
#include <IGESGeom_BoundedSurface.hxx>
#include <IGESGeom_TrimmedSurface.hxx>
#include <IGESSolid_Face.hxx>
#include <IGESToBRep.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XSControl_TransferReader.hxx>

#include "geometry/occ/read/transferred_faces.h"

namespace af2::geometry {

namespace {

bool isIgesFace(const Handle(Standard_Transient) & entity) {
  return entity->IsKind(STANDARD_TYPE(IGESGeom_TrimmedSurface)) ||
         entity->IsKind(STANDARD_TYPE(IGESGeom_BoundedSurface)) ||
         entity->IsKind(STANDARD_TYPE(IGESSolid_Face));
}

/// A surface without a boundary of its own that nothing else uses is a face, too.
bool isLooseSurface(const Handle(Standard_Transient) & entity, const Interface_Graph& graph) {
  const auto iges = Handle(IGESData_IGESEntity)::DownCast(entity);
  return !iges.IsNull() && IGESToBRep::IsTopoSurface(iges) && iges->SubordinateStatus() == 0 &&
         graph.Sharings(entity).NbEntities() == 0;
}

}  // namespace

std::vector<std::string> lostIgesFaces(const Handle(XSControl_WorkSession) & session) {
  const Handle(Interface_InterfaceModel) model = session->Model();
  const Handle(Transfer_TransientProcess) process = session->TransferReader()->TransientProcess();
  std::vector<std::string> lost;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(Standard_Transient) entity = model->Value(i);
    if (!isIgesFace(entity) && !isLooseSurface(entity, session->Graph())) continue;
    if (!hasBecomeFace(process, entity)) lost.push_back(model->StringLabel(entity)->ToCString());
  }
  return lost;
}

}  // namespace af2::geometry
