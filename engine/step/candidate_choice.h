// Chooses the rule to apply at one base edge: scores all matches of all rules, then tests their
// free zones in order of score and takes the first that is free.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/step/application.h"
#include "engine/step/candidate_score.h"
#include "engine/step/compiled_rules.h"
#include "engine/step/neighborhood.h"
#include "engine/step/observer.h"
#include "engine/step/rule_matcher.h"
#include "engine/step/zone_polygon.h"
#include "engine/surface/size_field.h"

namespace af2 {

/// Asks the mesh whether a weld is possible, which the front alone cannot tell.
class WeldGuard {
 public:
  virtual ~WeldGuard() = default;
  /// first  the place of the first of the two edges
  virtual bool allows(const StepChart& chart, PlaceId first, const Application& application) = 0;
};

/// Reused from step to step, so that nothing is allocated after the first steps.
class CandidateChoice {
 public:
  CandidateChoice(const CompiledRules& rules, const Front& front, const FrontIndex& index,
                  const SizeField& size, const std::vector<std::uint8_t>& valence);

  /// For a region known to lie within a box: no new vertex is placed outside it.
  void keepWithin(const Box3& box) { limits_ = box; }
  /// No quadrilateral with a reflex corner is made, even if the rule set accepts some.
  void refuseReflex() { refusesReflex_ = true; }
  /// Without a guard, the front alone decides about welds. Keeps a pointer.
  void askAboutWelds(WeldGuard& guard) { weldGuard_ = &guard; }

  /// The best applicable rule at the edge that leaves `base`, or null. Valid until the next call.
  const Application* choose(const StepChart& chart, PlaceId base);

  /// Number of candidates in all steps so far. Where very many edges were visited, they count, too.
  std::size_t examined() const { return examined_; }

  /// For each rule, in order, why it is not applied. Call it before the front changes.
  std::vector<RuleRefusal> explain(const StepChart& chart, PlaceId base);

  /// Every vertex and edge that hits the free zone of any match of any rule, one entry for each.
  std::vector<RuleRefusal> obstacles(const StepChart& chart, PlaceId base);

 private:
  void gather(const StepChart& chart, PlaceId base);
  void show(const StepView& view, const Window& wanted);
  template <class Find>
  void showAllMatches(const StepView& view, const Find& find);
  void collect(const StepView& view, std::span<const RuleAtLevel> rules);
  void collectShown(const StepView& view, std::span<const RuleAtLevel> rules);
  const Application* firstFree(const StepView& view, double bound);
  bool isInTheWay(const RuleAtLevel& at, const Match& match) const;
  void countExamined(std::size_t lookedAt);
  std::size_t bestUntried() const;
  void sortWorstFirst();
  bool isBetter(const Candidate& one, const Candidate& other) const;
  Refusal testFront(const StepView& view, const Candidate& candidate, RuleRefusal& culprit);
  bool keepsLoopsEven(const StepView& view, const Candidate& candidate);
  Refusal testWeld(const StepView& view, const Candidate& candidate);
  Refusal testClearance(const StepView& view, const Candidate& candidate, RuleRefusal& culprit);
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
  std::vector<Candidate> candidates_;   // as many as there ever were in one step
  std::size_t collected_ = 0;           // how many of them belong to this step
  std::vector<std::uint32_t> untried_;  // indices of this step's candidates not tried yet
  ZonePolygon polygon_;
  // Whether the last step's rule was wide: the next one is likely to be, too.
  bool wasWide_ = false;
  std::size_t examined_ = 0;
  Application application_;
  WeldGuard* weldGuard_ = nullptr;
  bool refusesReflex_ = false;
  Box3 limits_{{-1e300, -1e300, -1e300}, {1e300, 1e300, 1e300}};
};

}  // namespace af2
