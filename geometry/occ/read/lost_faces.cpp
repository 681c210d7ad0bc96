#include "geometry/occ/read/lost_faces.h"

#include <IGESData_IGESEntity.hxx>
#include <IGESGeom_BoundedSurface.hxx>
#include <IGESGeom_TrimmedSurface.hxx>
#include <IGESSolid_Face.hxx>
#include <IGESToBRep.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_Face.hxx>
#include <StepShape_HArray1OfFace.hxx>
#include <StepShape_OrientedFace.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TransferBRep.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <set>

namespace af2::geometry {

namespace {

bool isThere(const Handle(Transfer_TransientProcess) & process,
             const Handle(Standard_Transient) & face) {
  const TopoDS_Shape shape = TransferBRep::ShapeResult(process, face);
  return !shape.IsNull() && TopExp_Explorer(shape, TopAbs_FACE).More();
}

std::string labelOf(const Handle(StepData_StepModel) & model,
                    const Handle(Standard_Transient) & entity) {
  return "#" + std::to_string(model->IdentLabel(entity));
}

Handle(StepShape_Face) withoutSense(const Handle(StepShape_Face) & face) {
  const auto oriented = Handle(StepShape_OrientedFace)::DownCast(face);
  return oriented.IsNull() ? face : oriented->FaceElement();
}

class LostFaces {
 public:
  explicit LostFaces(const Handle(XSControl_WorkSession) & session)
      : session_(session),
        model_(Handle(StepData_StepModel)::DownCast(session->Model())),
        process_(session->TransferReader()->TransientProcess()) {}

  std::vector<std::string> find(const std::vector<TakenFace>& taken) {
    for (const TakenFace& face : taken)
      if (wasTried(face.shell)) report(face.name);
    for (int i = 1; i <= model_->NbEntities(); ++i) {
      const auto shell = Handle(StepShape_ConnectedFaceSet)::DownCast(model_->Value(i));
      if (!shell.IsNull() && wasTried(shell)) lookAt(shell);
    }
    return std::move(lost_);
  }

 private:
  /// Shells may be in a file without belonging to its shape.
  bool wasTried(const Handle(Standard_Transient) & shell) const {
    if (!process_->Find(shell).IsNull()) return true;
    Interface_EntityIterator users = session_->Graph().Sharings(shell);
    for (users.Start(); users.More(); users.Next())
      if (!process_->Find(users.Value()).IsNull()) return true;
    return false;
  }

  void lookAt(const Handle(StepShape_ConnectedFaceSet) & shell) {
    if (shell->CfsFaces().IsNull()) return;
    for (int k = 1; k <= shell->NbCfsFaces(); ++k) {
      const Handle(StepShape_Face) face = withoutSense(shell->CfsFacesValue(k));
      if (face.IsNull() || !isThere(process_, face)) report(stepFaceName(model_, shell, k));
    }
  }

  void report(const std::string& name) {
    if (reported_.insert(name).second) lost_.push_back(name);
  }

  Handle(XSControl_WorkSession) session_;
  Handle(StepData_StepModel) model_;
  Handle(Transfer_TransientProcess) process_;
  std::set<std::string> reported_;
  std::vector<std::string> lost_;
};

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

std::string stepFaceName(const Handle(StepData_StepModel) & model,
                         const Handle(StepShape_ConnectedFaceSet) & shell, int number) {
  const Handle(StepShape_Face) face = withoutSense(shell->CfsFacesValue(number));
  if (face.IsNull()) return "number " + std::to_string(number) + " of " + labelOf(model, shell);
  const std::string label = labelOf(model, face);
  if (face->Name().IsNull() || face->Name()->IsEmpty()) return label;
  return label + " '" + face->Name()->ToCString() + "'";
}

std::vector<std::string> lostIgesFaces(const Handle(XSControl_WorkSession) & session) {
  const Handle(Interface_InterfaceModel) model = session->Model();
  const Handle(Transfer_TransientProcess) process = session->TransferReader()->TransientProcess();
  std::vector<std::string> lost;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(Standard_Transient) entity = model->Value(i);
    if (!isIgesFace(entity) && !isLooseSurface(entity, session->Graph())) continue;
    if (!isThere(process, entity)) lost.push_back(model->StringLabel(entity)->ToCString());
  }
  return lost;
}

std::vector<std::string> lostStepFaces(const Handle(XSControl_WorkSession) & session,
                                       const std::vector<TakenFace>& taken) {
  return LostFaces(session).find(taken);
}

}  // namespace af2::geometry
