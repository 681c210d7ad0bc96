// What an observer is told of one step of the front.
// Not installed.
#pragma once

#include <optional>
#include <vector>

#include "engine/front/front.h"
#include "engine/mesh/mesh.h"
#include "engine/step/application.h"
#include "engine/step/candidate_choice.h"
#include "engine/step/front_piece.h"
#include "engine/step/observer.h"

namespace af2 {

/// What rules may see of the front at a base edge, with room to spare.
LocalFront frontAround(const Front& front, const StepChart& chart, PlaceId base);

/// Collects it while the step is taken; keeps references to its arguments.
class ObservedStep {
 public:
  ObservedStep(AF2MeshingObserver& observer, const Front& front, PlaceId base);

  /// Before a rule is chosen, while the front is as it was.
  void look(CandidateChoice& choice, const StepChart& chart);
  /// A rule has been chosen, and will be applied.
  void note(const Application& application);
  /// The step has been taken, or the edge refused.
  void tell(const Mesh& mesh);

 private:
  AF2MeshingObserver& observer_;
  const Front& front_;
  PlaceId base_;
  StepReport report_;
  std::vector<RuleRefusal> refusals_;
  std::optional<LocalFront> around_;
};

}  // namespace af2
