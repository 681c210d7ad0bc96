#include "geometry/occ/step/lost_step_faces.h"

#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <StepData_StepModel.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_Face.hxx>
#include <StepShape_HArray1OfFace.hxx>
#include <StepShape_OrientedFace.hxx>
#include <TCollection_HAsciiString.hxx>
#include <Transfer_Binder.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <set>

#include "geometry/occ/read/transferred_faces.h"

namespace af2::geometry {

namespace {

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
      if (face.IsNull() || !hasBecomeFace(process_, face)) report(stepFaceName(model_, shell, k));
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

}  // namespace

std::string stepFaceName(const Handle(StepData_StepModel) & model,
                         const Handle(StepShape_ConnectedFaceSet) & shell, int number) {
  const Handle(StepShape_Face) face = withoutSense(shell->CfsFacesValue(number));
  if (face.IsNull()) return "number " + std::to_string(number) + " of " + labelOf(model, shell);
  const std::string label = labelOf(model, face);
  if (face->Name().IsNull() || face->Name()->IsEmpty()) return label;
  return label + " '" + face->Name()->ToCString() + "'";
}

std::vector<std::string> lostStepFaces(const Handle(XSControl_WorkSession) & session,
                                       const std::vector<TakenFace>& taken) {
  return LostFaces(session).find(taken);
}

}  // namespace af2::geometry
