// Observing, timing and stopping a run from outside.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/ids.h"
#include "engine/mesh/front_input.h"
#include "engine/mesh/mesh.h"
#include "engine/rule/refusal.h"
#include "engine/step/front_piece.h"

namespace af2 {

class FinishObserver;

/// Why one rule was not applied at one base edge. If several matches of the rule were tried, this
/// is the reason of the match that passed the most checks.
struct RuleRefusal {
  std::size_t rule = 0;  ///< index in the rule set
  Refusal reason = Refusal::None;
  VertexId from, to;        ///< what hit the free zone: a vertex (`from` alone) or an edge
  std::size_t matches = 0;  ///< number of matches of the rule that were tried
  std::vector<VertexId> matched = {};  ///< of the match that came farthest, in pattern order
  std::optional<double> score = {};    ///< of that match, if it has one
  double seconds = 0;                  ///< for finding and testing all matches
};

/// One step of the advance.
struct StepReport {
  VertexId from, to;  ///< the base edge
  Point3 fromPoint, toPoint;
  int level = 1;
  bool applied = false;
  std::size_t rule = 0;  ///< if applied: the rule and its score
  double score = 0;
  double ruleSeconds = 0;  ///< for all matches of this rule, if the observer wants refusals
  std::size_t elements = 0, frontEdges = 0;  ///< after the step
};

/// What an advance did beside adding elements.
struct FrontAct {
  enum class Kind {
    Weld,     ///< `vertex` has become `other`
    Row,      ///< a row was complete; `count` vertices were moved
    Columns,  ///< `count` vertices got counts of their own
    Path,     ///< a path of `count` edges from `vertex` to `other`
  };
  Kind kind{};
  VertexId vertex, other;
  std::size_t count = 0;
};

/// How often an advance did what a FrontAct tells.
struct FrontActCounts {
  std::size_t welds = 0, rows = 0, moves = 0, columns = 0, paths = 0;

  /// Visits each count with its name in reports.
  void forEach(auto&& visit) const {
    visit("welds", welds);
    visit("rows", rows);
    visit("moves", moves);
    visit("columns", columns);
    visit("paths", paths);
  }
  FrontActCounts& operator+=(const FrontActCounts& more) {
    welds += more.welds;
    rows += more.rows;
    moves += more.moves;
    columns += more.columns;
    paths += more.paths;
    return *this;
  }
  bool operator==(const FrontActCounts&) const = default;
};

/// Receives every step of a run. Called from the thread that runs the engine.
class AF2_EXPORT AF2MeshingObserver {
 public:
  virtual ~AF2MeshingObserver() = default;
  /// A front begins: a region, one of the pieces of a large region, or another attempt at one of
  /// them. The ids of vertices are those of this front until the next one begins.
  virtual void frontBegun(const FrontInput&) {}
  virtual void stepTaken(const StepReport&) {}
  /// Follows `stepTaken` if a rule was applied: the mesh so far. The elements of the step are its
  /// last ones.
  virtual void meshGrown(const StepReport&, const Mesh&) {}
  /// Whether `rulesRefused` should be called, which costs time.
  virtual bool wantsRefusals() const { return false; }
  /// Called after `stepTaken` with the reason for each rule that was not applied.
  virtual void rulesRefused(const StepReport&, std::span<const RuleRefusal>) {}
  /// Whether `frontAround` should be called for the step that is about to be taken at this base
  /// edge, which is given with its level. It costs time in proportion to the length of the front.
  virtual bool wantsFrontAround(const StepReport&) const { return false; }
  /// Follows `stepTaken`: the front around the base edge, as it was before the step.
  virtual void frontAround(const StepReport&, const LocalFront&) {}
  /// Something beside adding elements, and the mesh after it. A weld comes before its `stepTaken`.
  virtual void frontActed(const FrontAct&, const Mesh&) {}
  /// The front ended, with this number of edges that no rule took; 0: it closed.
  virtual void frontEnded(std::size_t /*edgesLeft*/) {}
  /// The observer of what is done to meshes after their fronts have closed, or null.
  virtual FinishObserver* finishing() { return nullptr; }
};

/// The progress of a run. Sent every few thousand steps, or more often where steps take long.
struct Progress {
  std::size_t elements = 0;
  std::size_t frontEdges = 0;
  std::size_t candidates = 0;  ///< examined so far: determines the running time
  /// Of the elements, in units of FrontOptions::areaUnit, rounded down. A whole number, so that the
  /// sum over pieces does not depend on their order.
  std::size_t area = 0;
};
using ProgressCallback = std::function<void(const Progress&)>;

}  // namespace af2
