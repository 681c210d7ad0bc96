// What `af2 mesh` records during a run: the trace and the statistics of the rules.
#pragma once

#include <functional>
#include <list>
#include <mutex>
#include <vector>

#include "cli/meshing/mesh_request.h"
#include "cli/meshing/rule_statistics.h"
#include "cli/meshing/trace_file.h"
#include "engine/rule/rule_set.h"

namespace af2::cli {

/// Passes what it hears to two observers.
class ObserverPair final : public AF2MeshingObserver {
 public:
  ObserverPair(AF2MeshingObserver& first, AF2MeshingObserver& second)
      : first_(first), second_(second) {}
  void frontBegun(const FrontInput& input) override;
  void stepTaken(const StepReport& step) override;
  void meshGrown(const StepReport& step, const Mesh& mesh) override;
  void frontActed(const FrontAct& act, const Mesh& mesh) override;
  bool wantsRefusals() const override;
  void rulesRefused(const StepReport& step, std::span<const RuleRefusal> refusals) override;
  bool wantsFrontAround(const StepReport& step) const override;
  void frontAround(const StepReport& step, const LocalFront& front) override;
  void frontEnded(std::size_t edgesLeft) override;
  /// That of the first one that has one: no two need it.
  FinishObserver* finishing() override;

 private:
  AF2MeshingObserver &first_, &second_;
};

/// The recorders of a run, as far as the request asks for them. Must outlive the run.
class RunRecorders {
 public:
  RunRecorders(const MeshRequest& request, const RuleSet& rules);

  /// Of each face; empty if there is nothing to record.
  std::function<AF2MeshingObserver*(int face)> observers();
  /// What a run has to tell about the names of a model, to find the faces that are traced; empty if
  /// none are named. It throws InputError for names that the model does not have.
  std::function<void(std::span<const std::string>, std::span<const geometry::FaceGroup>)>
  nameListener();
  /// Writes the trace file. Throws InputError if it cannot be written.
  void writeTrace();
  /// All zero without statistics.
  const RuleCounters& counters() const { return counters_; }

 private:
  AF2MeshingObserver* observerOf(int face);

  const MeshRequest& request_;
  const RuleSet& rules_;
  TraceRecorder trace_;
  RuleCounters counters_;
  std::mutex mutex_;
  std::list<ObserverPair> pairs_;  // which stay where they are
};

}  // namespace af2::cli
