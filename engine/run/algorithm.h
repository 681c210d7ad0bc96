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

/// Optional settings and hooks of an advance of the front; the defaults do nothing.
struct FrontOptions {
  AF2MeshingObserver* observer = nullptr;
  ProgressCallback progress;  ///< called from the thread that runs the engine
  std::stop_token stop;       ///< may be requested from any thread; takes effect within a few steps
  /// A run ends as stuck after this number of steps per front edge, and at least two progress
  /// reports, in which fewer than 64 elements were added. 0: no such limit; a run ends when no
  /// front edge is left to try.
  int stallSteps = 0;
  /// A run ends as stuck after examining this number of candidates, plus 60 per front edge, in
  /// which fewer than 64 elements were added. 0: no such limit.
  std::size_t stallCandidates = 0;
  /// Whether rule sets that accept quadrilaterals with a reflex corner get them. The caller then
  /// has to mend them, as `meshRegion` does.
  bool acceptReflex = true;
  double areaUnit = 0;          ///< of Progress::area, a squared length; 0: areas are not measured
  double expectedElements = 0;  ///< memory is reserved for this many, so that it need not grow
};

enum class Outcome { Complete, Stuck, Cancelled };

/// A front edge that no rule took, with each rule's last reason for refusing it.
struct StuckEdge {
  VertexId from, to;
  int level = 1;
  std::vector<RuleRefusal> refusals;
  /// The front around the edge; only for the first few edges that are left, else without vertices.
  LocalFront around = {};
};

/// The result of a run: always the mesh so far, and how the run ended.
struct MeshingResult {
  Outcome outcome = Outcome::Complete;
  Mesh mesh;                     ///< the input's vertices with their ids, then the new vertices
  std::vector<StuckEdge> stuck;  ///< what is left of a front that got stuck, or was refused in one
                                 ///< that was stopped
  std::vector<VertexId> unused;  ///< isolated vertices that no element uses
  std::size_t steps = 0, failedSteps = 0;
  FrontActCounts acts;
  std::size_t candidates = 0;  ///< examined in all steps: determines the running time
};

/// The engine. Holds a compiled rule set; meshes any number of regions with it, from any number of
/// threads at once.
class AF2_EXPORT AF2Algorithm {
 public:
  explicit AF2Algorithm(std::shared_ptr<const RuleSet> rules);
  ~AF2Algorithm();
  AF2Algorithm(AF2Algorithm&&) noexcept;
  AF2Algorithm& operator=(AF2Algorithm&&) noexcept;

  /// Meshes the region that `input` bounds.
  ///
  /// Throws InputError if the input is not a set of closed loops (an edge of length zero, an id out
  /// of range, the same directed edge twice, a vertex with two positions, a number that is not
  /// finite, a flat region whose loops run the wrong way round) or if a size is not positive.
  /// Getting stuck and being cancelled are results, not errors.
  MeshingResult execute(const AF2LocalTransformMaker& maker, const FrontInput& input,
                        const SizeField& size, const FrontOptions& options = {}) const;

  const RuleSet& rules() const;

 private:
  struct Compiled;
  std::unique_ptr<const Compiled> compiled_;
};

}  // namespace af2
