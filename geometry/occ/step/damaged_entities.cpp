#include "geometry/occ/step/damaged_entities.h"

#include <Interface_Check.hxx>
#include <Interface_EntityIterator.hxx>
#include <Interface_Graph.hxx>
#include <Interface_ReportEntity.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_HArray1OfPcurveOrSurface.hxx>
#include <StepGeom_Pcurve.hxx>
#include <StepGeom_SurfaceCurve.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_Face.hxx>
#include <StepShape_HArray1OfFace.hxx>
#include <StepShape_OrientedFace.hxx>
#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

namespace af2::geometry {

namespace {

bool isOfType(const Handle(Standard_Transient) & entity, const char* start) {
  return std::strncmp(entity->DynamicType()->Name(), start, std::strlen(start)) == 0;
}

bool isShape(const Handle(Standard_Transient) & entity) {
  return isOfType(entity, "StepGeom_") || isOfType(entity, "StepShape_");
}

/// Messages in the report on an entity that make it unusable. Other faults, e.g. a name without
/// quotes, are common and harmless.
const char* damageIn(const Handle(Interface_Check) & check, bool hasValues) {
  constexpr std::array kReferences{"illegal type", "nresolved"};
  constexpr std::array kValues{"not a Real", "not an Integer", "not a LIST", "Count of Parameters"};
  for (int i = 1; i <= check->NbFails(); ++i) {
    const char* const text = check->CFail(i);
    const auto isIn = [text](const char* part) { return std::strstr(text, part) != nullptr; };
    if (std::ranges::any_of(kReferences, isIn)) return text;
    if (hasValues && std::ranges::any_of(kValues, isIn)) return text;
  }
  return nullptr;
}

class Damage {
 public:
  Damage(const Handle(XSControl_WorkSession) & session, std::map<int, std::string> unusable)
      : session_(session),
        model_(Handle(StepData_StepModel)::DownCast(session->Model())),
        unusable_(std::move(unusable)) {}

  StepDamage takeOut() {
    for (int i = 1; i <= model_->NbEntities(); ++i) lookAt(i);
    if (count_ == 0) return {};
    session_->ComputeGraph(true);
    spread();
    takeOutFaces();
    return {(count_ == 1 ? "an entity of this STEP file is damaged"
                         : std::to_string(count_) + " entities of this STEP file are damaged") +
                (" (" + first_ + ")"),
            std::move(faces_)};
  }

 private:
  void lookAt(int number) {
    const Handle(Standard_Transient) entity = model_->Value(number);
    // Damage to what only concerns the picture of the model is harmless.
    if (isOfType(entity, "StepVisual_")) return;
    const int label = model_->IdentLabel(entity);
    std::string fault;
    if (const auto unusable = unusable_.find(label); isShape(entity) && unusable != unusable_.end())
      fault = unusable->second + " is not a usable number";
    if (fault.empty() && model_->IsReportEntity(number))
      if (const char* damage = damageIn(model_->ReportEntity(number)->Check(), isShape(entity)))
        fault = damage;
    if (fault.empty()) return;
    const bool isWorse = isShape(entity) && !isShapeHit_;  // damage elsewhere rarely matters
    faults_.push_back("#" + std::to_string(label) + ": " + fault);
    if (count_++ == 0 || isWorse) first_ = faults_.back();
    isShapeHit_ |= isWorse;
    reached_.emplace(number, faults_.size() - 1);
  }

  /// Goes from damaged entities to all that depend on them, up to their faces. Curves in parameters
  /// can be done without.
  void spread() {
    std::vector<int> open;
    for (const auto& [number, fault] : reached_) open.push_back(number);
    while (!open.empty()) {
      const std::size_t fault = reached_.at(open.back());
      const Handle(Standard_Transient) entity = model_->Value(open.back());
      open.pop_back();
      if (entity->IsKind(STANDARD_TYPE(StepShape_Face))) continue;
      const bool isInParameters = entity->IsKind(STANDARD_TYPE(StepGeom_Pcurve));
      Interface_EntityIterator users = session_->Graph().Sharings(entity);
      for (users.Start(); users.More(); users.Next()) {
        const auto curve = Handle(StepGeom_SurfaceCurve)::DownCast(users.Value());
        if (isInParameters && !curve.IsNull()) {
          curve->SetAssociatedGeometry(new StepGeom_HArray1OfPcurveOrSurface());
          continue;
        }
        const int number = model_->Number(users.Value());
        if (isShape(users.Value()) && reached_.emplace(number, fault).second)
          open.push_back(number);
      }
    }
  }

  /// What is wrong with a face; nothing if it can be used. Missing entities must not be transferred
  /// either.
  std::optional<std::string> faultOf(const Handle(StepShape_Face) & face) const {
    if (face.IsNull()) return "the file does not contain it";
    const auto found = reached_.find(model_->Number(face));
    if (found != reached_.end()) return faults_[found->second];
    const auto oriented = Handle(StepShape_OrientedFace)::DownCast(face);
    return oriented.IsNull() ? std::nullopt : faultOf(oriented->FaceElement());
  }

  void takeOutFaces() {
    for (int i = 1; i <= model_->NbEntities(); ++i) {
      const auto shell = Handle(StepShape_ConnectedFaceSet)::DownCast(model_->Value(i));
      if (shell.IsNull() || shell->CfsFaces().IsNull()) continue;
      std::vector<Handle(StepShape_Face)> kept;
      for (int k = 1; k <= shell->NbCfsFaces(); ++k) {
        const std::optional<std::string> fault = faultOf(shell->CfsFacesValue(k));
        if (fault)
          faces_.push_back({shell, stepFaceName(model_, shell, k) + " (" + *fault + ")"});
        else
          kept.push_back(shell->CfsFacesValue(k));
      }
      if (std::ssize(kept) < shell->NbCfsFaces()) shell->SetCfsFaces(arrayOf(kept));
    }
  }

  static Handle(StepShape_HArray1OfFace) arrayOf(const std::vector<Handle(StepShape_Face)>& faces) {
    if (faces.empty()) return new StepShape_HArray1OfFace();
    const Handle(StepShape_HArray1OfFace) array =
        new StepShape_HArray1OfFace(1, static_cast<int>(faces.size()));
    int next = 0;
    for (const Handle(StepShape_Face) & face : faces) array->SetValue(++next, face);
    return array;
  }

  Handle(XSControl_WorkSession) session_;
  Handle(StepData_StepModel) model_;
  std::map<int, std::string> unusable_;  ///< by label
  int count_ = 0;
  bool isShapeHit_ = false;
  std::string first_;
  std::vector<std::string> faults_;
  /// By number of entities that are damaged or depend on such: the fault.
  std::map<int, std::size_t> reached_;
  std::vector<TakenFace> faces_;
};

}  // namespace

StepDamage takeOutDamage(const Handle(XSControl_WorkSession) & session,
                         std::map<int, std::string> unusable) {
  return Damage(session, std::move(unusable)).takeOut();
}

}  // namespace af2::geometry
