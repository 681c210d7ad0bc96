// Chooses what to do at one base edge: scores every match of every rule, then tests free zones in
// order of score and takes the first that is free.
#pragma once

#include <optional>
#include <vector>

#include "engine/step/candidate_score.h"
#include "engine/step/compiled_rules.h"
#include "engine/step/neighborhood.h"
#include "engine/step/observer.h"
#include "engine/step/open_places.h"
#include "engine/step/rule_matcher.h"
#include "engine/step/zone_polygon.h"
#include "engine/surface/size_field.h"

namespace af2 {

/// A new vertex on the surface, or nothing. The chart writes it where it stays: what has just been
/// put together in pieces is slow to copy.
struct LiftedPoint {
  std::optional<SurfacePoint> point;
  LiftedPoint(const StepChart& chart, Point2 inChart) : point(chart.lift(inChart)) {}
};

/// The chosen candidate, with everything that is needed to apply it.
struct Application {
  const CompiledRule* rule = nullptr;
  double score = 0;
  OpenPlaces open;
  std::vector<LiftedPoint> newPoints;  ///< by new vertex; none is missing
};

/// Reused from step to step; after the first steps nothing is allocated.
class CandidateChoice {
 public:
  CandidateChoice(const CompiledRules& rules, const Front& front, const FrontIndex& index,
                  const SizeField& size, const std::vector<std::uint8_t>& valence);

  /// For a region known to lie within a box: no new vertex is put outside of it.
  void keepWithin(const Box3& box) { limits_ = box; }

  /// The best applicable rule at the edge that leaves `base`, or null. Valid until the next call.
  const Application* choose(const StepChart& chart, PlaceId base);

  /// How many candidates there were in all steps so far; edges count as some where they are many.
  std::size_t examined() const { return examined_; }

  /// For each rule in order why it is not the one to apply; call it before the front changes.
  std::vector<RuleRefusal> explain(const StepChart& chart, PlaceId base);

  /// All that hits the free zone of any match of any rule, each thing for itself.
  std::vector<RuleRefusal> obstacles(const StepChart& chart, PlaceId base);

 private:
  void gather(const StepChart& chart, PlaceId base);
  void collect(const StepView& view);
  bool isInTheWay(const RuleAtLevel& at, const Match& match) const;
  void countCrowd(std::size_t lookedAt);
  std::size_t bestUntried() const;
  void sortWorstFirst();
  bool isBetter(const Candidate& one, const Candidate& other) const;
  Refusal testZone(const StepView& view, const Candidate& candidate, RuleRefusal& culprit);
  template <class Visit>
  Refusal visitObstacles(const StepView& view, const Candidate& candidate, Visit&& visit);
  template <class Zone, class Visit>
  void searchZone(const StepView& view, const Candidate& candidate, Box2 box, const Zone& zone,
                  Visit&& visit);
  std::vector<Match> matchesOf(const StepView& view, const RuleAtLevel& at);
  Refusal prepare(const StepView& view, const Candidate& candidate);
  RuleRefusal explainRule(const StepView& view, const RuleAtLevel& at);
  RuleRefusal explainMatch(const StepView& view, const CompiledRule& rule, const Match& match);
  StepView viewOf(const StepChart& chart, PlaceId base) const;

  const CompiledRules& rules_;
  const Front& front_;
  const FrontIndex& index_;
  const SizeField& size_;
  const std::vector<std::uint8_t>& valence_;
  DrawnBase drawn_;
  Neighborhood near_;
  RuleMatcher matcher_;
  CandidateScorer scorer_;
  std::vector<Candidate> candidates_;   // as many as there ever were at once
  std::vector<std::uint32_t> untried_;  // those of this step that have not been tried yet
  ZonePolygon polygon_;
  bool wasWide_ = false;  // the last step's rule: the next one is likely to be like it
  std::size_t examined_ = 0;
  Application application_;
  Box3 limits_{{-1e300, -1e300, -1e300}, {1e300, 1e300, 1e300}};
};

}  // namespace af2
