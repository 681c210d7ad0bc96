// What an advance does beside the steps of rules that add elements: welds, the end of rows, paths.
// Not installed.
#pragma once

#include <optional>
#include <vector>

#include "engine/run/advance.h"
#include "engine/run/algorithm.h"
#include "engine/run/weld.h"
#include "engine/step/candidate_choice.h"
#include "engine/step/compiled_rules.h"

namespace af2 {

class FrontActs final : public WeldGuard {
 public:
  /// Keeps references to all that `advance` refers to, and to the other arguments.
  FrontActs(const CompiledRules& rules, const Advance& advance, const SizeField& size,
            std::vector<std::uint8_t>& valence, AF2MeshingObserver* observer);

  const FrontActCounts& counts() const { return counts_; }
  /// The mesh has new elements, from this one on.
  void enter(std::size_t firstElement) {
    if (needsElements_) advance_.elements.enter(advance_.mesh, firstElement);
  }

  /// Whether anything happens at the end of rows.
  bool haveRows() const { return set_.rowRounds > 0 || set_.columns; }
  /// A row is complete when the next edge lies in a higher layer than all edges before it.
  bool endsRow(PlaceId base);
  /// Smooths the front and plans columns, as the rule set says.
  void finishRow();

  /// Whether the weld of a candidate keeps the mesh sound; remembers it.
  bool allows(const StepChart& chart, PlaceId first, const Application& application) override;
  /// The weld that was allowed last. `change` tells what it did to the front.
  void weld(Front::Change& change);
  /// Removes vertices that welds have left without elements from the numbering.
  void dropDeadVertices(MeshingResult& result);

  /// Divides a loop by a path; returns false if no rule says how.
  bool layPath(Front::Change& change);

 private:
  void tell(const FrontAct& act) {
    if (observer_) observer_->frontActed(act, advance_.mesh);
  }

  const CompiledRules& rules_;
  const RuleSetDefinition& set_;
  Advance advance_;
  const SizeField& size_;
  std::vector<std::uint8_t>& valence_;
  AF2MeshingObserver* observer_;
  bool needsElements_;
  FrontActCounts counts_;
  std::optional<Weld> weld_;
  std::vector<VertexId> dead_;
  std::int32_t row_ = 0;  ///< the row that is being made
};

}  // namespace af2
