#include "engine/step/candidate_choice.h"

#include <algorithm>
#include <cmath>

#include "engine/base/stopwatch.h"
#include "engine/mesh/element_shape.h"
#include "engine/step/clearance.h"
#include "engine/step/matched_parts.h"
#include "engine/step/surroundings.h"
#include "engine/step/zone_tests.h"

namespace af2 {
namespace {

/// If there are more candidates than this, they are sorted instead of searched.
constexpr std::size_t kManyCandidates = 64;

bool isAtNewVertex(const Candidate& candidate, Point2 p) {
  const auto first = static_cast<std::size_t>(candidate.rule->matchedCount);
  const auto end = first + static_cast<std::size_t>(candidate.rule->newCount);
  for (std::size_t v = first; v < end; ++v)
    if (distance(candidate.match.points[v], p) <= kSamePlace) return true;
  return false;
}

bool hasReflexElement(const Candidate& candidate) {
  return std::ranges::any_of(
      candidate.rule->rule->definition().elements, [&](const RuleElement& element) {
        return !turnsLeftEverywhere(ElementCorners(element, candidate.match.points.data()).span());
      });
}

/// Returns false also if a coordinate is NaN.
bool holds(const Box3& box, const Point3& p) {
  return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y &&
         p.z >= box.low.z && p.z <= box.high.z;
}

}  // namespace

CandidateChoice::CandidateChoice(const CompiledRules& rules, const Front& front,
                                 const FrontIndex& index, const SizeField& size,
                                 const std::vector<std::uint8_t>& valence)
    : rules_(rules),
      front_(front),
      index_(index),
      size_(size),
      valence_(valence),
      matcher_(index, size, valence),
      scorer_(rules, index, size, valence) {}

StepView CandidateChoice::viewOf(const StepChart& chart, PlaceId base) const {
  const int level = front_[base].level;
  return {front_, near_, chart, drawn_, base, level, rules_.set().matchTolerance(level)};
}

void CandidateChoice::gather(const StepChart& chart, PlaceId base) {
  drawn_.draw(front_, chart, base);
  const double baseLength = drawn_.b.point.position.x;
  near_.gather(front_, index_, chart, base,
               rules_.windowAt(front_[base].level, baseLength, wasWide_));
}

/// Rules whose scores have the same lower bound are tried together, those with low bounds first.
/// The rest is left out once a free candidate is better than what the rest could be.
const Application* CandidateChoice::choose(const StepChart& chart, PlaceId base) {
  gather(chart, base);
  countExamined(near_.lookedAt());
  const StepView view = viewOf(chart, base);
  untried_.clear();
  collected_ = 0;
  std::span<const RuleAtLevel> rules = rules_.rulesAt(view.level);
  while (!rules.empty()) {
    const auto end = std::ranges::find_if(
        rules, [&](const RuleAtLevel& at) { return at.leastScore > rules.front().leastScore; });
    const auto count = static_cast<std::size_t>(end - rules.begin());
    collect(view, rules.first(count));
    rules = rules.subspan(count);
    const double bound = rules.empty() ? INFINITY : rules.front().leastScore;
    if (const Application* chosen = firstFree(view, bound)) return chosen;
  }
  wasWide_ = false;
  return nullptr;
}

/// The best of the collected candidates that is free, if its score is below the bound.
const Application* CandidateChoice::firstFree(const StepView& view, double bound) {
  RuleRefusal culprit;
  // Where a front is crowded there may be thousands of candidates, few of which are free.
  const bool isSorted = untried_.size() > kManyCandidates;
  if (isSorted) sortWorstFirst();
  while (!untried_.empty()) {
    const std::size_t best = isSorted ? untried_.size() - 1 : bestUntried();
    const Candidate& candidate = candidates_[untried_[best]];
    if (!(candidate.score < bound)) return nullptr;
    countExamined(near_.edges().size());
    if (testFront(view, candidate, culprit) == Refusal::None &&
        prepare(view, candidate) == Refusal::None) {
      wasWide_ = candidate.rule->isWide;
      return &application_;
    }
    untried_[best] = untried_.back();
    untried_.pop_back();
  }
  return nullptr;
}

/// Where a front is crowded, visiting all nearby edges takes as long as testing many candidates, so
/// these edges are counted in candidates.
void CandidateChoice::countExamined(std::size_t lookedAt) {
  constexpr std::size_t kOrdinary = 256, kLikeACandidate = 32;
  if (lookedAt > kOrdinary) examined_ += (lookedAt - kOrdinary) / kLikeACandidate;
}

std::size_t CandidateChoice::bestUntried() const {
  std::size_t best = 0;
  for (std::size_t i = 1; i < untried_.size(); ++i)
    if (isBetter(candidates_[untried_[i]], candidates_[untried_[best]])) best = i;
  return best;
}

void CandidateChoice::sortWorstFirst() {
  std::ranges::sort(untried_, [&](std::uint32_t one, std::uint32_t other) {
    return isBetter(candidates_[other], candidates_[one]);
  });
}

/// Gathers a larger neighborhood if the present one does not show all of a window.
void CandidateChoice::show(const StepView& view, const Window& wanted) {
  if (near_.window().contains(wanted)) return;
  Window larger = near_.window();
  larger.include(wanted);
  near_.gather(front_, index_, view.chart, view.base, larger);
  countExamined(near_.lookedAt());
}

/// Computed places may lie outside the usual neighborhood. They depend on chains, which are found
/// whatever the neighborhood holds, or on each other, so that a few repetitions show them all.
template <class Find>
void CandidateChoice::showAllMatches(const StepView& view, const Find& find) {
  constexpr int kMaxRepetitions = 4;
  for (int i = 0; i < kMaxRepetitions; ++i) {
    matcher_.moveTo(view);
    find();
    if (near_.window().contains(matcher_.wanted())) return;
    show(view, matcher_.wanted());
  }
}

void CandidateChoice::collect(const StepView& view, std::span<const RuleAtLevel> rules) {
  const std::size_t firstUntried = untried_.size(), first = collected_;
  showAllMatches(view, [&] {
    untried_.resize(firstUntried);
    collected_ = first;
    collectShown(view, rules);
  });
}

void CandidateChoice::collectShown(const StepView& view, std::span<const RuleAtLevel> rules) {
  // Scoring a match takes as long as visiting this many edges.
  constexpr std::size_t kLikeEdges = 4;
  std::size_t refused = 0;
  for (const RuleAtLevel& at : rules) {
    const CompiledRule& rule = *at.rule;
    matcher_.forEachMatch(*at.pattern, [&](const Match& match) {
      ++examined_;
      if (isInTheWay(at, match)) return;
      if (collected_ == candidates_.size()) candidates_.emplace_back();
      Candidate& candidate = candidates_[collected_];
      candidate.rule = &rule;
      candidate.match.take(match, rule.matchedCount);
      if (scorer_.evaluate(view, candidate) == Refusal::None)
        untried_.push_back(static_cast<std::uint32_t>(collected_++));
      else
        ++refused;
    });
  }
  examined_ -= refused;
  countExamined(matcher_.lookedAt() + kLikeEdges * refused);
}

/// Whether a front edge next to the base is clearly in the zone of a match. In most steps this
/// refutes the best matches, so that neither a score nor a zone is computed for them.
bool CandidateChoice::isInTheWay(const RuleAtLevel& at, const Match& match) const {
  if (!at.zone) return false;
  const FastZone& zone = *at.rule->zone;
  const Point2 *points = match.points.data(), *before = matcher_.beforeBase(),
               *after = matcher_.afterBase();
  return (before && zone.cornerAtA >= 0 &&
          plainlyRunsInto(*at.zone, zone.cornerAtA, points, points[0], *before)) ||
         (after && zone.cornerAtB >= 0 &&
          plainlyRunsInto(*at.zone, zone.cornerAtB, points, points[1], *after));
}

bool CandidateChoice::isBetter(const Candidate& one, const Candidate& other) const {
  if (one.score != other.score) return one.score < other.score;
  const int priority = one.rule->rule->definition().priority;
  const int otherPriority = other.rule->rule->definition().priority;
  if (priority != otherPriority) return priority < otherPriority;
  if (one.rule->index != other.rule->index) return one.rule->index < other.rule->index;
  for (std::size_t v = 0; v < static_cast<std::size_t>(one.rule->matchedCount); ++v) {
    const PlaceId p = one.match.places[v], q = other.match.places[v];
    if (front_[p].vertex != front_[q].vertex) return front_[p].vertex < front_[q].vertex;
    if (p != q) return p < q;
  }
  return false;
}

/// Whether the front lets a candidate be: its loops, the free zone, and the clearance.
Refusal CandidateChoice::testFront(const StepView& view, const Candidate& candidate,
                                   RuleRefusal& culprit) {
  if (!keepsLoopsEven(view, candidate)) return Refusal::Parity;
  const Refusal zone = testZone(view, candidate, culprit);
  return zone == Refusal::None ? testClearance(view, candidate, culprit) : zone;
}

bool CandidateChoice::keepsLoopsEven(const StepView& view, const Candidate& candidate) {
  if (!front_.loops().areNumbered() || !candidate.rule->rule->makesElements()) return true;
  OpenPlaces& open = application_.open;
  // Without open places, the candidate is refused later, for that reason.
  return !findOpenPlaces(view, *candidate.rule, candidate.match, open) ||
         front_.loops().allow(front_, view.base, open.joined);
}

Refusal CandidateChoice::testClearance(const StepView& view, const Candidate& candidate,
                                       RuleRefusal& culprit) {
  const auto& byLevel = rules_.set().definition().clearance;
  if (byLevel.empty()) return Refusal::None;
  const double clearance = byLevel[static_cast<std::size_t>(view.level - 1)];
  show(view, clearanceWindow(candidate, clearance));
  const Neighborhood::Edge* edge = tooCloseEdge(front_, near_, candidate, clearance);
  if (!edge) return Refusal::None;
  culprit.from = edge->vertex;
  culprit.to = edge->isEdge ? front_[front_.next(edge->place)].vertex : VertexId();
  return Refusal::Clearance;
}

Refusal CandidateChoice::testZone(const StepView& view, const Candidate& candidate,
                                  RuleRefusal& culprit) {
  Refusal hit = Refusal::None;
  const auto stopAt = [&](Refusal reason, VertexId from, VertexId to) {
    hit = reason;
    culprit.from = from;
    culprit.to = to;
    return false;
  };
  const Refusal refusal = visitObstacles(view, candidate, stopAt);
  return refusal == Refusal::None ? hit : refusal;
}

/// Returns why there is no zone at this match, or None.
template <class Visit>
Refusal CandidateChoice::visitObstacles(const StepView& view, const Candidate& candidate,
                                        Visit&& visit) {
  if (candidate.rule->zone) {
    if (!polygon_.make(*candidate.rule->zone, view.level, candidate.match.points.data()))
      return Refusal::Convexity;
    searchZone(view, candidate, polygon_.boundingBox(), polygon_, visit);
    return Refusal::None;
  }
  const auto corners = candidate.rule->zoneVertices;
  if (!corners.empty() && polygon_.makeOf(corners, candidate.match.points.data())) {
    searchZone(view, candidate, polygon_.boundingBox(), polygon_, visit);
    return Refusal::None;
  }
  const FrontSurroundings surroundings(view, index_, *candidate.rule->rule, candidate.match, size_,
                                       valence_);
  const auto made = candidate.rule->rule->definition().zone->makeFreeZone(
      {candidate.matchedPoints(), view.level, &surroundings});
  if (!made.zone) return made.refusal;
  searchZone(view, candidate, made.zone->boundingBox(), *made.zone, visit);
  return Refusal::None;
}

/// Visits vertices first, then edges, until `visit` returns false.
template <class Zone, class Visit>
void CandidateChoice::searchZone(const StepView& view, const Candidate& candidate, Box2 box,
                                 const Zone& zone, Visit&& visit) {
  const Window wanted{box.low.x, box.low.y, box.high.x, box.high.y};
  show(view, wanted);
  const MatchedParts matched(front_, candidate);
  const ZoneBox reach(box, kSamePlace), room(box);
  for (const Neighborhood::Edge& edge : near_.edges()) {
    if (!reach.holds(edge.from)) continue;
    if (matched.holdVertex(edge.vertex)) continue;
    if (!zone.contains(edge.from, ZoneBoundary::Counts) && !isAtNewVertex(candidate, edge.from))
      continue;
    if (!visit(Refusal::ZoneHitByVertex, edge.vertex, VertexId())) return;
  }
  for (const Neighborhood::Edge& edge : near_.edges()) {
    if (!edge.isEdge || !room.mayMeet(edge.from, edge.to) || matched.holdEdge(edge.place)) continue;
    if (!zone.meets(edge.from, edge.to, ZoneBoundary::Ignored)) continue;
    const VertexId end = front_[front_.next(edge.place)].vertex;
    if (!visit(Refusal::ZoneHitByEdge, edge.vertex, end)) return;
  }
}

Refusal CandidateChoice::prepare(const StepView& view, const Candidate& candidate) {
  application_.rule = candidate.rule;
  application_.score = candidate.score;
  const bool makesElements = candidate.rule->rule->makesElements();
  if (!makesElements)
    application_.open.places.assign(candidate.match.places.begin(),
                                    candidate.match.places.begin() + candidate.rule->matchedCount);
  else if (!findOpenPlaces(view, *candidate.rule, candidate.match, application_.open))
    return Refusal::Inverted;
  if (refusesReflex_ && hasReflexElement(candidate)) return Refusal::Inverted;
  application_.newPoints.clear();
  for (int k = 0; k < candidate.rule->newCount; ++k) {
    const auto v = static_cast<std::size_t>(candidate.rule->matchedCount + k);
    application_.newPoints.emplace_back(view.chart, candidate.match.points[v]);
    const auto& lifted = application_.newPoints.back().point;
    if (!lifted || !holds(limits_, lifted->position)) return Refusal::Surface;
  }
  if (!makesElements) return testWeld(view, candidate);
  if (view.chart.isPlane()) return Refusal::None;
  const int reflexCorners = rules_.scoring().allowsReflexAt(view.level) ? 1 : 0;
  return staysUnfolded(view.front, application_, reflexCorners) ? Refusal::None : Refusal::Surface;
}

Refusal CandidateChoice::testWeld(const StepView& view, const Candidate& candidate) {
  const int middle = candidate.rule->rule->weldMiddle();
  const PlaceId first = middle == 1 ? view.base : front_.previous(view.base);
  return !weldGuard_ || weldGuard_->allows(view.chart, first, application_) ? Refusal::None
                                                                            : Refusal::Weld;
}

std::vector<RuleRefusal> CandidateChoice::obstacles(const StepChart& chart, PlaceId base) {
  gather(chart, base);
  const StepView view = viewOf(chart, base);
  std::vector<RuleRefusal> found;
  for (const RuleAtLevel& at : rules_.rulesAt(view.level)) {
    const CompiledRule& rule = *at.rule;
    for (const Match& match : matchesOf(view, at)) {
      Candidate candidate{0, &rule, match};
      const Refusal reason = scorer_.evaluate(view, candidate);
      if (reason == Refusal::Require || reason == Refusal::NoValue) continue;
      visitObstacles(view, candidate, [&](Refusal hit, VertexId from, VertexId to) {
        found.push_back({rule.index, hit, from, to});
        return true;
      });
    }
  }
  return found;
}

/// A zone test may gather the neighborhood again, so all matches are collected first.
std::vector<Match> CandidateChoice::matchesOf(const StepView& view, const RuleAtLevel& at) {
  std::vector<Match> matches;
  showAllMatches(view, [&] {
    matches.clear();
    matcher_.forEachMatch(*at.pattern, [&](const Match& match) { matches.push_back(match); });
  });
  return matches;
}

std::vector<RuleRefusal> CandidateChoice::explain(const StepChart& chart, PlaceId base) {
  gather(chart, base);
  const StepView view = viewOf(chart, base);
  std::vector<RuleRefusal> refusals;
  for (const CompiledRule& rule : rules_.rules())
    refusals.push_back({rule.index, Refusal::Class, {}, {}});
  for (const RuleAtLevel& at : rules_.rulesAt(view.level))
    refusals[at.rule->index] = explainRule(view, at);
  return refusals;
}

RuleRefusal CandidateChoice::explainRule(const StepView& view, const RuleAtLevel& at) {
  const Stopwatch watch;
  RuleRefusal result{at.rule->index, Refusal::Pattern, {}, {}};
  const std::vector<Match> matches = matchesOf(view, at);
  for (const Match& match : matches) {
    RuleRefusal refusal = explainMatch(view, *at.rule, match);
    if (refusal.reason > result.reason) result = std::move(refusal);
  }
  result.matches = matches.size();
  result.seconds = watch.seconds();
  return result;
}

RuleRefusal CandidateChoice::explainMatch(const StepView& view, const CompiledRule& rule,
                                          const Match& match) {
  Candidate candidate{0, &rule, match};
  RuleRefusal result{rule.index, scorer_.evaluate(view, candidate), {}, {}};
  for (std::size_t v = 0; v < static_cast<std::size_t>(rule.matchedCount); ++v)
    result.matched.push_back(front_[match.places[v]].vertex);
  if (result.reason == Refusal::None || result.reason == Refusal::Score)
    result.score = candidate.score;
  // Inverted elements and scores are reported after the zone although they are cheaper to test.
  if (result.reason == Refusal::Require || result.reason == Refusal::NoValue) return result;
  const Refusal front = testFront(view, candidate, result);
  if (front != Refusal::None) result.reason = front;
  if (result.reason == Refusal::None) result.reason = prepare(view, candidate);
  if (result.reason == Refusal::None) result.reason = Refusal::Beaten;
  return result;
}

}  // namespace af2
