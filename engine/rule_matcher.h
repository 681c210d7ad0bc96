// Enumerates every way to bind a rule's pattern to the front around one base edge.
#pragma once

#include <array>
#include <utility>

#include "engine/compiled_rules.h"
#include "engine/front.h"
#include "engine/neighborhood.h"

namespace af2 {

/// What one step of the advance looks at.
struct StepView {
  const Front& front;
  const Neighborhood& near;
  const StepChart& chart;
  PlaceId base;
  int level;
  double tolerance;  ///< largest value of a tolerance form at this level
};

/// A bound pattern: places and chart positions by pattern vertex; then room for the new vertices.
struct Match {
  std::array<PlaceId, AF2Rule::kMaxVertices> places;
  std::array<Point2, AF2Rule::kMaxVertices + AffineBatch::kCapacity> points;

  /// Takes over the first `count` vertices of another match, and nothing else.
  void take(const Match& other, int count) {
    for (std::size_t v = 0; v < static_cast<std::size_t>(count); ++v) {
      places[v] = other.places[v];
      points[v] = other.points[v];
    }
  }
};

/// Calls visit(const Match&) for every complete binding of one rule. Used again from step to step.
class RuleMatcher {
 public:
  /// Goes to the base edge of a step; `view` must be there for as long as matches are asked for.
  void moveTo(const StepView& view);

  /// The far end of the edge of the front that arrives at the base, or of the one that leaves it;
  /// null if there is none, or if it is out of sight.
  const Point2* beforeBase() const {
    return view_->front.hasEdge(beforeBase_.place) ? seen(beforeBase_) : nullptr;
  }
  const Point2* afterBase() const {
    return view_->front.hasEdge(match_.places[1]) ? seen(afterBase_) : nullptr;
  }

  template <class Visit>
  void forEachMatch(const CompiledRule& rule, Visit&& visit) {
    bind(rule.patternAt(view_->level), 0, visit);
  }

 private:
  struct Candidate {
    PlaceId place;
    ChartPoint point;
  };

  static const Point2* seen(const Candidate& candidate) {
    return candidate.point.view == ChartView::Hidden ? nullptr : &candidate.point.position;
  }

  template <class Visit>
  void bind(const CompiledPattern& pattern, std::size_t index, Visit& visit) {
    if (index == pattern.steps.size()) {
      if (slopesFit(pattern)) visit(std::as_const(match_));
      return;
    }
    const BindingStep& step = pattern.steps[index];
    const PlaceId from =
        step.from < 0 ? PlaceId() : match_.places[static_cast<std::size_t>(step.from)];
    switch (step.kind) {
      case BindingStep::Kind::Closes:
        if (view_->front.hasEdge(from) &&
            view_->front.next(from) == match_.places[static_cast<std::size_t>(step.vertex)])
          bind(pattern, index + 1, visit);
        return;
      case BindingStep::Kind::Next:
      case BindingStep::Kind::Previous: {
        if (!(step.kind == BindingStep::Kind::Next ? view_->front.hasEdge(from)
                                                   : view_->front.hasEdgeBefore(from)))
          return;
        const Candidate& candidate =
            step.kind == BindingStep::Kind::Next ? after(from) : before(from);
        if (accept(pattern, index, candidate.place, candidate.point.position,
                   candidate.point.view == ChartView::Legal))
          bind(pattern, index + 1, visit);
        return;
      }
      case BindingStep::Kind::Any:
        for (const Neighborhood::Edge& edge : view_->near.edges())
          if (accept(pattern, index, edge.place, edge.from, edge.view == ChartView::Legal))
            bind(pattern, index + 1, visit);
        return;
    }
  }

  /// Binds the vertex of a step if the place fits it.
  bool accept(const CompiledPattern& pattern, std::size_t index, PlaceId place, Point2 point,
              bool isLegal) {
    const BindingStep& step = pattern.steps[index];
    if (!step.fits(point, view_->tolerance)) return false;
    if (!isLegal || isBound(pattern, index, view_->front[place].vertex)) return false;
    const auto vertex = static_cast<std::size_t>(step.vertex);
    match_.places[vertex] = place;
    match_.points[vertex] = point;
    return true;
  }

  /// Whether an earlier step has bound this mesh vertex: pattern vertices are all different.
  bool isBound(const CompiledPattern& pattern, std::size_t index, VertexId id) const;
  bool slopesFit(const CompiledPattern& pattern) const;
  /// Both are valid until the next call.
  const Candidate& after(PlaceId place);
  const Candidate& before(PlaceId place);
  void lookAt(PlaceId place, Candidate& candidate) const {
    const ChartPoint point = view_->chart.project(view_->front[place].point);
    candidate.place = place;
    candidate.point.position = point.position;
    candidate.point.view = point.view;
  }

  const StepView* view_ = nullptr;
  Match match_;
  Candidate afterBase_, beforeBase_;  // what nearly every rule asks for
  Candidate other_;
};

}  // namespace af2
