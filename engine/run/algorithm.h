// The advancing front: from a boundary, a chart maker and a rule set to a mesh.
#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "engine/base/export.h"
#include "engine/mesh/front_input.h"
#include "engine/mesh/mesh.h"
#include "engine/rule/rule_set.h"
#include "engine/step/observer.h"
#include "engine/surface/local_transform.h"
#include "engine/surface/size_field.h"

namespace af2 {

/// Extras of a run; the defaults do nothing.
struct MeshingOptions {
  AF2MeshingObserver* observer = nullptr;
  ProgressCallback progress;  ///< called from the thread that runs the engine
  std::stop_token stop;       ///< may be requested from any thread; answered within a few steps
  /// A run ends as stuck after so many steps in a row for each edge of its front, and much work at
  /// least, that brought next to nothing. 0: only when no edge is left that could be tried.
  int patience = 0;
  /// Nor does a run go on that has examined so many candidates, and 60 more for each edge of its
  /// front, since it brought something. 0: it does.
  std::size_t mostInVain = 0;
  double expectedElements = 0;  ///< room is made for about so many, so that it need not grow
};

enum class Outcome { Complete, Stuck, Cancelled };

/// A front edge that no rule took, and why each rule was refused last.
struct StuckEdge {
  VertexId from, to;
  int level = 1;
  std::vector<RuleRefusal> refusals;
};

/// What a run gives: always the mesh so far, and how it ended.
struct MeshingResult {
  Outcome outcome = Outcome::Complete;
  Mesh mesh;                     ///< vertices of the input first, with their ids, then the new ones
  std::vector<StuckEdge> stuck;  ///< front edges that are left, if stuck
  std::vector<VertexId> unused;  ///< isolated vertices that no element uses
  std::size_t steps = 0, failedSteps = 0;
  std::size_t candidates = 0;  ///< examined in all steps: with these goes the time
};

/// The engine. Holds a rule set, compiled; meshes any number of regions with it, from any number of
/// threads at once.
class AF2_EXPORT AF2Algorithm {
 public:
  explicit AF2Algorithm(std::shared_ptr<const RuleSet> rules);
  ~AF2Algorithm();
  AF2Algorithm(AF2Algorithm&&) noexcept;
  AF2Algorithm& operator=(AF2Algorithm&&) noexcept;

  /// Meshes the region that `input` bounds.
  ///
  /// Throws InputError if the input is no set of closed loops: an edge of length zero, an id out of
  /// range, the same directed edge twice, a vertex with two positions, a number that is not finite,
  /// a flat region whose loops run the wrong way round;
  /// or if a size is not positive. Getting stuck and being cancelled are results, not errors.
  MeshingResult execute(const AF2LocalTransformMaker& maker, const FrontInput& input,
                        const SizeField& size, const MeshingOptions& options = {}) const;

  const RuleSet& rules() const;

 private:
  struct Compiled;
  std::unique_ptr<const Compiled> compiled_;
};

}  // namespace af2
