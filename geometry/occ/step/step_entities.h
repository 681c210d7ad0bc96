// The entities of a STEP file, and the shapes that they became.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_HGraph.hxx>
#include <StepData_StepModel.hxx>
#include <TopoDS_Shape.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

namespace af2::geometry {

class StepEntities {
 public:
  explicit StepEntities(const Handle(XSControl_WorkSession) & session)
      : session_(session), process_(session->TransferReader()->TransientProcess()) {}

  /// Null if there is no entity, or if none was made of it.
  TopoDS_Shape shapeOf(const Handle(Standard_Transient) & entity) const {
    return entity.IsNull() ? TopoDS_Shape() : TransferBRep::ShapeResult(process_, entity);
  }

  template <class Visit>
  void forEach(const Visit& visit) const {
    const auto& model = session_->Model();
    for (int i = 1; i <= model->NbEntities(); ++i) visit(model->Value(i));
  }

  /// Calls `visit` with all entities of a type that refer to another.
  template <class Type, class Visit>
  void forEachUser(const Handle(Standard_Transient) & of, const Visit& visit) const {
    Interface_EntityIterator users = session_->HGraph()->Graph().Sharings(of);
    for (users.Start(); users.More(); users.Next()) {
      const auto user = opencascade::handle<Type>::DownCast(users.Value());
      if (!user.IsNull()) visit(user);
    }
  }

 private:
  Handle(XSControl_WorkSession) session_;
  Handle(Transfer_TransientProcess) process_;
};

}  // namespace af2::geometry
