// Z2: how many matches are refused for an invalid zone? Z3: does the zone shrink with the level?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "dsl/proof/changed_rules.h"
#include "dsl/proof/rule_sample.h"
#include "dsl/proof/test_text.h"
#include "dsl/proof/zone_depth.h"

namespace af2::dsl {
namespace {

/// An outline of `poly` that crosses itself is usually that of elements which are inverted there:
/// the engine refuses such a match anyway, so its zone loses nothing.
bool isLost(const SampledMatch& one) {
  return one.zoneRefusal == Refusal::Convexity ||
         (one.zoneRefusal == Refusal::Shape && hasPositiveElements(one));
}

struct Growth {
  int level = 0, laterLevel = 0;
  double depth = 0;
  Point2 at;
};

std::unique_ptr<const AF2FreeZone> zoneAt(const PatternMatch& match, int level) {
  const PatternMatch other(match.rule(), match.vertices(), level);
  return match.rule().definition().zone->makeFreeZone(other.binding()).zone;
}

/// A place inside the later zone and outside the earlier one, close to a point of the boundary of
/// the later zone. The answer is exact, independent of rounding in the point.
bool isGrown(const AF2FreeZone& early, const AF2FreeZone& late, Point2 p) {
  constexpr double kInwards = 1e-4;
  const Box2 box = late.boundingBox();
  const Point2 inner = p + kInwards * (0.5 * (box.low + box.high) - p);
  return !early.contains(inner, ZoneBoundary::Counts) &&
         late.contains(inner, ZoneBoundary::Ignored);
}

/// The deepest point of the zone at a later level outside of the zone at an earlier one.
Growth growthAt(const PatternMatch& match, int level, int laterLevel) {
  Growth growth{level, laterLevel, 0, {}};
  const auto early = zoneAt(match, level), late = zoneAt(match, laterLevel);
  if (!early || !late) return growth;
  const MeasuredZone measured(*early), later(*late);
  for (const auto& loop : later.outlineLoops())
    for (const Point2 p : loop) {
      if (!isGrown(*early, *late, p)) continue;
      const double depth = measured.depthOutside(p);
      if (depth <= growth.depth) continue;
      growth.depth = depth;
      growth.at = p;
    }
  return growth;
}

/// A place with few digits that only the later zone contains, close to the place of the largest
/// growth.
Point2 grownPlace(const PatternMatch& match, const Growth& growth) {
  const auto early = zoneAt(match, growth.level), late = zoneAt(match, growth.laterLevel);
  const Box2 box = late->boundingBox();
  const Point2 middle = 0.5 * (box.low + box.high);
  for (const double digits : {1e2, 1e3, 1e4, 1e6})
    for (const double t : {0.02, 0.01, 0.003, 0.001, 1e-4}) {
      const Point2 p = growth.at + t * (middle - growth.at);
      const Point2 q{std::round(p.x * digits) / digits, std::round(p.y * digits) / digits};
      if (!early->contains(q, ZoneBoundary::Counts) && late->contains(q, ZoneBoundary::Ignored))
        return q;
    }
  return growth.at;
}

Growth worstGrowth(const PatternMatch& match, const std::vector<int>& levels) {
  Growth worst;
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    const Growth growth = growthAt(match, levels[i], levels[i + 1]);
    if (growth.depth > worst.depth) worst = growth;
  }
  return worst;
}

FrontPiece pieceWith(const PatternMatch& match, Point2 obstacle) {
  FrontPiece piece = pieceOf(match, match.level());
  piece.isolated.push_back(piece.vertices.size());
  piece.vertices.push_back(obstacle);
  return piece;
}

/// A lost match, and what a test expects there once no match is lost to the zone.
struct LostMatch {
  SampledMatch match;
  std::string expectation;
};

/// The lost match that is nearest to the reference, of those at which the rule would be chosen if
/// its zone were a path. Else the nearest one, where the rule is refused for another reason then.
LostMatch nearestLost(const RuleSample& sample, const SampledMatch* reference) {
  constexpr std::size_t kTries = 60;
  std::vector<const SampledMatch*> lost;
  for (const SampledMatch& one : sample.matches)
    if (isLost(one)) lost.push_back(&one);
  std::ranges::stable_sort(lost, {}, [](const SampledMatch* one) { return one->deviation; });
  if (reference) lost.insert(lost.begin(), reference);
  ChangedRules changed =
      ChangedRules::replacing(sample.rules, sample.index, withPathAsZone(sample.rule.definition()));
  const auto isChosen = [&](const SampledMatch& one) {
    return isLost(one) && changed.chooses(pieceOf(one.match, sample.level));
  };
  for (std::size_t i = 0; i < std::min(kTries, lost.size()); ++i)
    if (isChosen(*lost[i]))
      return {simplified(*lost[i], sample.rules, isChosen),
              fmt::format("rule \"{}\"", sample.name())};
  return {simplified(*lost.front(), sample.rules, isLost), refusedOtherwise(sample.name())};
}

SampledFinding growthFinding(const RuleSample& sample, const PatternMatch& match,
                             const Growth& growth, int count, int looked) {
  SampledFinding finding = findingAbout(sample, Code::GrowingZone);
  finding.message = fmt::format(
      "the free zone of rule '{}' grows as the level rises: at {} of {} matches, by up to {:.2g} "
      "from level {} to {}",
      sample.name(), count, looked, growth.depth, growth.level, growth.laterLevel);
  finding.help = "keep the limiting corners, right of '=>', inside the preferred zone";
  const Point2 obstacle = grownPlace(match, growth);
  finding.example = {match.vertices(), growth.laterLevel, {growth.at}, {obstacle}};
  const PatternMatch later(sample.rule, match.vertices(), growth.laterLevel);
  ChangedRules kept = ChangedRules::replacing(sample.rules, sample.index,
                                              withZoneKept(sample.rule.definition(), growth.level));
  const bool isChosen = kept.chooses(pieceWith(later, obstacle));
  finding.test = writeTest(
      later,
      {fmt::format("{}: what is free at level {} stays free", sample.name(), growth.level),
       {obstacle},
       isChosen ? fmt::format("rule \"{}\"", sample.name()) : refusedOtherwise(sample.name())});
  return finding;
}

}  // namespace

double shareOfLost(const RuleSample& sample) {
  if (sample.matches.empty()) return 0;
  const auto lost = std::ranges::count_if(sample.matches, isLost);
  return static_cast<double>(lost) / static_cast<double>(sample.matches.size());
}

std::optional<SampledFinding> findLost(const RuleSample& sample) {
  constexpr double kTolerable = 0.2;
  const double share = shareOfLost(sample);
  const SampledMatch reference = examine(PatternMatch::atReference(sample.rule, sample.level));
  const bool isAccepted = reference.match.refusalOfMatch(sample.rules) == Refusal::None;
  const bool losesReference = isAccepted && isLost(reference);
  if (share <= kTolerable && !losesReference) return std::nullopt;

  const auto [example, expectation] = nearestLost(sample, losesReference ? &reference : nullptr);
  SampledFinding finding = findingAbout(sample, Code::InvalidZone);
  const bool isConvexity = example.zoneRefusal == Refusal::Convexity;
  finding.message =
      fmt::format("{} of the matches of rule '{}' at level {} are refused because its zone {}",
                  percent(share), sample.name(), sample.level,
                  isConvexity ? "is not convex there" : "has no valid shape there");
  finding.help = isConvexity ? "use poly(...), which need not be convex, or other corners"
                             : "make the tolerance smaller, or give the shape another form";
  finding.example = {example.match.vertices(), sample.level, {}, {}};
  finding.test =
      writeTest(example.match,
                {fmt::format("{}: no match is lost to its zone", sample.name()), {}, expectation});
  return finding;
}

std::optional<SampledFinding> findGrowing(const RuleSample& sample) {
  constexpr int kLooked = 200, kCurvedLooked = 8;  // outlines of curved zones are expensive
  const auto levels = levelsOf(sample.rules, sample.rule);
  const auto reference = PatternMatch::atReference(sample.rule, sample.level);
  Growth worst = worstGrowth(reference, levels);
  PatternMatch match = reference;
  int count = worst.depth > 0, looked = 1;
  for (const SampledMatch& one : sample.matches) {
    if (!one.zone) continue;
    if (looked > (isConvexPolygon(*one.zone) ? kLooked : kCurvedLooked)) break;
    ++looked;
    const Growth growth = worstGrowth(one.match, levels);
    count += growth.depth > 0;
    if (growth.depth <= worst.depth) continue;
    const auto shows = [&](const SampledMatch& other) {
      return other.zone && worstGrowth(other.match, levels).depth > worst.depth;
    };
    match = simplified(one, sample.rules, shows).match;
    worst = worstGrowth(match, levels);
  }
  if (count == 0) return std::nullopt;
  return growthFinding(sample, match, worst, count, looked);
}

}  // namespace af2::dsl
