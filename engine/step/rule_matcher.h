// Enumerates every way to bind a rule's pattern to the front around one base edge.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "engine/front/front.h"
#include "engine/step/compiled_rules.h"
#include "engine/step/neighborhood.h"
#include "engine/surface/size_field.h"

namespace af2 {

/// The input of one step of the advance.
struct StepView {
  const Front& front;
  const Neighborhood& near;
  const StepChart& chart;
  const DrawnBase& drawn;
  PlaceId base;
  int level;
  double tolerance;  ///< largest value of a tolerance form at this level
};

/// A bound pattern: places and chart positions by pattern vertex, then storage for the new
/// vertices.
struct Match {
  std::array<PlaceId, AF2Rule::kMaxVertices> places;
  std::array<Point2, AF2Rule::kMaxVertices + AffineBatch::kCapacity> points;

  /// Copies only the first `count` vertices of another match.
  void take(const Match& other, int count) {
    for (std::size_t v = 0; v < static_cast<std::size_t>(count); ++v) {
      places[v] = other.places[v];
      points[v] = other.points[v];
    }
  }
};

/// Calls visit(const Match&) for every complete binding of one rule. Reused from step to step.
class RuleMatcher {
 public:
  /// Keeps references to all arguments.
  RuleMatcher(const FrontIndex& index, const SizeField& size,
              const std::vector<std::uint8_t>& valence)
      : index_(index), size_(size), valence_(valence) {}

  /// Moves to the base edge of a step; `view` must outlive all calls for that step.
  void moveTo(const StepView& view);

  /// The corner before the base (after it), at the far end of the adjacent front edge. Null if
  /// there is no such edge or the corner is hidden.
  const Point2* beforeBase() const { return before_.seen(); }
  const Point2* afterBase() const { return after_.seen(); }

  template <class Visit>
  void forEachMatch(const CompiledPattern& pattern, Visit&& visit) {
    if (pattern.steps.empty()) return visitIfSlopesFit(pattern, visit);
    // The corner beside the base rules out most rules, and testing it is fast.
    const BindingStep& first = pattern.steps.front();
    const Beside* beside = besideBase(first);
    if (!beside) return bind(pattern, 0, visit);
    const Point2 corner = beside->corner.point.position;
    if (!beside->isOpen || !first.fits(corner, view_->tolerance)) return;
    if (first.near && !isNear(pattern, first, corner)) return;
    take(first, beside->corner.place, corner);
    bind(pattern, 1, visit);
  }

  /// How many nearby edges were visited since the last move.
  std::size_t lookedAt() const { return lookedAt_; }
  /// What computed places asked for since the last move. If the neighborhood does not hold it,
  /// matches may be missing.
  const Window& wanted() const { return wanted_; }

 private:
  /// The corner before or after the base.
  struct Beside {
    DrawnBase::Corner corner;
    bool hasEdge = false;  ///< whether the front has an edge between it and the base
    bool isOpen = false;   ///< whether a vertex other than a and b may match it

    const Point2* seen() const {
      return hasEdge && corner.point.view != ChartView::Hidden ? &corner.point.position : nullptr;
    }
  };

  void look(const DrawnBase::Corner& corner, bool hasEdge, Beside& beside) const;
  /// The corner that a step binds if it is the first of its pattern, or null.
  const Beside* besideBase(const BindingStep& step) const {
    if (step.kind == BindingStep::Kind::Next && step.from == 1) return &after_;
    if (step.kind == BindingStep::Kind::Previous && step.from == 0) return &before_;
    return nullptr;
  }

  template <class Visit>
  void bind(const CompiledPattern& pattern, std::size_t index, Visit& visit) {
    if (index == pattern.steps.size()) return visitIfSlopesFit(pattern, visit);
    const BindingStep& step = pattern.steps[index];
    switch (step.kind) {
      case BindingStep::Kind::Closes:
        if (view_->front.hasEdge(placeOf(step.from)) &&
            view_->front.next(placeOf(step.from)) == placeOf(step.vertex))
          bind(pattern, index + 1, visit);
        return;
      case BindingStep::Kind::Next:
      case BindingStep::Kind::Previous: {
        const DrawnBase::Corner* corner = neighbor(step);
        if (corner && accept(pattern, index, corner->place, view_->front[corner->place].vertex,
                             corner->point.position, corner->point.view))
          bind(pattern, index + 1, visit);
        return;
      }
      case BindingStep::Kind::Any:
        lookedAt_ += view_->near.edges().size();
        for (const Neighborhood::Edge& edge : view_->near.edges())
          if (accept(pattern, index, edge.place, edge.vertex, edge.from, edge.view))
            bind(pattern, index + 1, visit);
        return;
      case BindingStep::Kind::Near:
        bindNear(pattern, index, visit);
        return;
    }
  }

  /// Not inlined, so that rules without computed places do not pay for them.
  template <class Visit>
  [[gnu::noinline]] void bindNear(const CompiledPattern& pattern, std::size_t index, Visit& visit) {
    const BindingStep& step = pattern.steps[index];
    const auto place = computedPlace(pattern, step);
    if (!place) return;
    lookedAt_ += view_->near.edges().size();
    for (const Neighborhood::Edge& edge : view_->near.edges())
      if (distance(edge.from, *place) <= step.reach && edge.view == ChartView::Legal &&
          !isBound(pattern, index, edge.vertex)) {
        take(step, edge.place, edge.from);
        bind(pattern, index + 1, visit);
      }
  }

  template <class Visit>
  void visitIfSlopesFit(const CompiledPattern& pattern, Visit& visit) {
    if (pattern.slopes.empty() || slopesFit(pattern)) visit(std::as_const(match_));
  }

  /// Binds the vertex of a step if the place fits. Inlined by force: most candidates end here.
  [[gnu::always_inline]] bool accept(const CompiledPattern& pattern, std::size_t index,
                                     PlaceId place, VertexId vertex, Point2 point, ChartView view) {
    const BindingStep& step = pattern.steps[index];
    if (!step.fits(point, view_->tolerance)) return false;
    if (step.near && !isNear(pattern, step, point)) return false;
    if (view != ChartView::Legal || isBound(pattern, index, vertex)) return false;
    take(step, place, point);
    return true;
  }

  void take(const BindingStep& step, PlaceId place, Point2 point) {
    const auto vertex = static_cast<std::size_t>(step.vertex);
    match_.places[vertex] = place;
    match_.points[vertex] = point;
  }

  PlaceId placeOf(std::int8_t vertex) const {
    return match_.places[static_cast<std::size_t>(vertex)];
  }
  /// Whether an earlier step has bound this mesh vertex: pattern vertices must be distinct.
  bool isBound(const CompiledPattern& pattern, std::size_t index, VertexId id) const;
  bool slopesFit(const CompiledPattern& pattern) const;
  /// Where a vertex is sought, given the vertices bound so far.
  std::optional<Point2> computedPlace(const CompiledPattern& pattern, const BindingStep& step);
  bool isNear(const CompiledPattern& pattern, const BindingStep& step, Point2 point);
  /// The target of a step along the front, or null if there is no edge. Valid until the next call.
  const DrawnBase::Corner* neighbor(const BindingStep& step);

  const FrontIndex& index_;
  const SizeField& size_;
  const std::vector<std::uint8_t>& valence_;
  const StepView* view_ = nullptr;
  std::size_t lookedAt_ = 0;
  Window wanted_;
  Match match_;
  Beside before_, after_;  // what nearly every rule asks for
  DrawnBase::Corner other_;
};

}  // namespace af2
