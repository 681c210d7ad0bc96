// Observing, timing and stopping a run from outside.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "engine/base/export.h"
#include "engine/base/ids.h"
#include "engine/rule/refusal.h"

namespace af2 {

/// Why one rule was not applied at one base edge. If several matches of the rule were tried, this
/// is the reason of the match that passed the most checks.
struct RuleRefusal {
  std::size_t rule = 0;  ///< index in the rule set
  Refusal reason = Refusal::None;
  VertexId from, to;  ///< what hit the free zone: a vertex (`from` alone) or an edge
};

/// One step of the advance.
struct StepReport {
  VertexId from, to;  ///< the base edge
  int level = 1;
  bool applied = false;
  std::size_t rule = 0;  ///< if applied: the rule and its score
  double score = 0;
  std::size_t elements = 0, frontEdges = 0;  ///< after the step
};

/// Receives every step of a run. Called from the thread that runs the engine.
class AF2_EXPORT AF2MeshingObserver {
 public:
  virtual ~AF2MeshingObserver() = default;
  virtual void stepTaken(const StepReport&) {}
  /// Whether `rulesRefused` should be called, which costs time.
  virtual bool wantsRefusals() const { return false; }
  /// Called after `stepTaken` with the reason for each rule that was not applied.
  virtual void rulesRefused(const StepReport&, std::span<const RuleRefusal>) {}
};

/// The progress of a run. Sent every few thousand steps, or more often where steps take long.
struct Progress {
  std::size_t elements = 0;
  std::size_t frontEdges = 0;
  std::size_t candidates = 0;  ///< examined so far: determines the running time
};
using ProgressCallback = std::function<void(const Progress&)>;

}  // namespace af2
