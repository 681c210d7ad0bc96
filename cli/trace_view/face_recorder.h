// Records what happens on one face.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "cli/trace_view/face_record.h"
#include "engine/rule/rule_set.h"
#include "engine/step/observer.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::cli {

/// Steps from `first` to `last`, numbered from 1 over all fronts of the face.
struct StepRange {
  std::size_t first = 1, last = 0;
  bool contains(std::size_t step) const { return step >= first && step <= last; }
};

class FaceRecorder final : public AF2MeshingObserver, public FinishObserver {
 public:
  /// charted  the steps whose charts are recorded, which costs time and memory
  FaceRecorder(const RuleSet& rules, int face, StepRange charted)
      : rules_(rules), charted_(charted) {
    record_.face = face;
  }

  FaceRecord& record() { return record_; }

  /// Adds the elements of a kept front that no step made and no change, because the rest of the
  /// front was closed without rules.
  void addClosing(const geometry::ModelMesh& mesh);

  void frontBegun(const FrontInput& input) override;
  void stepTaken(const StepReport& step) override;
  void meshGrown(const StepReport& step, const Mesh& mesh) override;
  /// It is asked before the step and again after it.
  bool wantsRefusals() const override {
    return charted_.contains(step_) || charted_.contains(step_ + 1);
  }
  void rulesRefused(const StepReport&, std::span<const RuleRefusal> refusals) override {
    refusals_.assign(refusals.begin(), refusals.end());
  }
  bool wantsFrontAround(const StepReport&) const override { return charted_.contains(step_ + 1); }
  void frontAround(const StepReport& step, const LocalFront& around) override;
  void frontActed(const FrontAct& act, const Mesh& mesh) override;
  void frontEnded(std::size_t edgesLeft) override;
  FinishObserver* finishing() override { return this; }

  void finishBegun(const Mesh& mesh) override;
  void vertexAdded(VertexId v, const Point3& place) override;
  void actKept(const FinishAct& act) override;
  void finishEnded(const Mesh& mesh, bool isSound) override;

 private:
  using Corners = std::array<VertexId, 4>;
  /// By corners: the number of an element that exists now.
  using Alive = std::map<Corners, std::size_t>;

  ViewEvent& addEvent(std::size_t kind, std::size_t front);
  void bear(const Element& element, std::size_t front);
  void close(std::size_t front, const geometry::ModelMesh& mesh);
  void bury(const Element& element, std::size_t front);
  void takeVertices(const Mesh& mesh);
  void weld(const Mesh& mesh);
  void move(std::uint32_t number, const Point3& to);
  bool isOf(const Mesh& mesh, const ViewFront& front) const;
  std::size_t turnedFront(const Mesh& mesh);
  void replaceElements(const Mesh& mesh, std::size_t front);
  std::int32_t now() const { return static_cast<std::int32_t>(record_.events.size()) - 1; }

  const RuleSet& rules_;
  StepRange charted_;
  FaceRecord record_;
  std::size_t step_ = 0;      ///< steps of the face so far
  std::vector<Alive> alive_;  ///< by front
  /// By front that has ended: the numbers of the vertices of its mesh.
  std::vector<std::vector<std::uint32_t>> numbers_;
  std::vector<Point3> places_;      ///< of the vertices of the front that runs
  std::vector<bool> isDead_;        ///< the same vertices: whether they were welded into others
  std::optional<FrontAct> welded_;  ///< by the step that is being taken
  std::vector<Element> made_;       ///< by the last step
  std::vector<RuleRefusal> refusals_;
  std::uint32_t numberOf(VertexId v, std::size_t front) const;

  std::vector<std::size_t> added_;  ///< numbers of the vertices that were added while finishing
  std::size_t finishing_ = kNone;   ///< the front whose mesh is being finished
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
};

}  // namespace af2::cli
