// G2: are all elements positive at every match?
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "dsl/match/match_sampler.h"
#include "dsl/proof/rule_sample.h"
#include "dsl/proof/test_text.h"
#include "engine/mesh/element_shape.h"

namespace af2::dsl {
namespace {

/// The corner at which an element does not turn left; nothing if it is positive.
std::optional<Point2> badCorner(const std::vector<Point2>& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (!turnsLeftAt(corners, i)) return corners[i];
  return std::nullopt;
}

struct Inverted {
  int element;
  Point2 corner;
};

std::optional<Inverted> firstInverted(const AF2Rule& rule, const std::vector<Point2>& placed) {
  const auto& elements = rule.definition().elements;
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (const auto corner = badCorner(cornersOf(elements[i], placed)))
      return Inverted{static_cast<int>(i), *corner};
  return std::nullopt;
}

std::optional<Inverted> invertedElement(const SampledMatch& one) {
  if (!one.zone || !one.placed) return std::nullopt;
  return firstInverted(one.match.rule(), *one.placed);
}

/// The smallest signed area of the parallelograms at the corners of the elements. It is continuous,
/// even where a side shrinks to zero length. Nothing if a vertex has no position.
std::optional<double> leastTurn(const PatternMatch& match) {
  const auto placed = match.placeAll();
  if (!placed) return std::nullopt;
  double least = std::numeric_limits<double>::infinity();
  for (const RuleElement& element : match.rule().definition().elements) {
    const auto corners = cornersOf(element, *placed);
    for (std::size_t i = 0, n = corners.size(); i < n; ++i)
      least = std::min(least, cross(corners[(i + 1) % n] - corners[i],
                                    corners[(i + 2) % n] - corners[(i + 1) % n]));
  }
  return least;
}

PatternMatch moved(const PatternMatch& match, double reach, RandomNumbers& random) {
  std::vector<Point2> vertices = match.vertices();
  for (std::size_t i = 2; i < vertices.size(); ++i)
    vertices[i] = vertices[i] + reach * random.inDisc();
  return PatternMatch(match.rule(), std::move(vertices), match.level());
}

/// Moves from a match to matches with flatter and flatter elements. This finds faults that occur at
/// one of a thousand matches and that random samples would miss.
std::optional<SampledMatch> flattened(const RuleSample& sample, SampledMatch best,
                                      RandomNumbers& random) {
  constexpr int kSteps = 200;
  double reach = 0.3, least = *leastTurn(best.match);
  const auto improve = [&](PatternMatch next) {
    const auto turn = leastTurn(next);
    if (!turn || *turn >= least || next.refusalOfMatch(sample.rules) != Refusal::None) return false;
    SampledMatch candidate = examine(std::move(next));
    if (!candidate.zone) return false;
    least = *turn;
    best = std::move(candidate);
    return true;
  };
  for (int step = 0; step < kSteps; ++step) {
    if (invertedElement(best)) return best;
    if (!improve(moved(best.match, reach, random))) reach *= 0.98;
  }
  return std::nullopt;
}

/// The condition that an element is positive: "convex(a, b, c, d)".
std::string leftTurnOf(const RuleDefinition& rule, int element) {
  const RuleElement& corners = rule.elements[static_cast<std::size_t>(element)];
  std::string names;
  for (std::size_t i = 0; i < static_cast<std::size_t>(corners.size()); ++i) {
    const auto v = static_cast<std::size_t>(corners.corners[i]);
    const bool isMatched = v < rule.vertices.size();
    names += (i == 0 ? "" : ", ") +
             (isMatched ? rule.vertices[v].name : rule.newVertexNames[v - rule.vertices.size()]);
  }
  return (corners.size() == 3 ? "ccw(" : "convex(") + names + ")";
}

SampledFinding invertedFinding(const RuleSample& sample, const SampledMatch& nearest,
                               std::string share) {
  const auto shows = [](const SampledMatch& one) { return invertedElement(one).has_value(); };
  const SampledMatch example = simplified(nearest, sample.rules, shows);
  const Inverted inverted = *invertedElement(example);
  SampledFinding finding = findingAbout(sample, Code::InvertibleElement);
  finding.element = inverted.element;
  finding.message =
      fmt::format("a new element is inverted at {} that rule '{}' accepts at level {}", share,
                  sample.name(), sample.level);
  finding.help = fmt::format("add `require {}` after the vertices, or make a tolerance smaller",
                             leftTurnOf(sample.rule.definition(), inverted.element));
  finding.example = {example.match.vertices(), sample.level, {inverted.corner}, {}};
  finding.test = writeTest(
      example.match,
      {fmt::format("{}: no element turns over", sample.name()),
       {},
       fmt::format("not rule \"{}\" because require or pattern or class", sample.name())});
  return finding;
}

}  // namespace

bool hasPositiveElements(const SampledMatch& one) {
  return one.placed && !firstInverted(one.match.rule(), *one.placed);
}

std::optional<SampledFinding> findInverted(const RuleSample& sample) {
  int count = 0, valid = 0;
  const SampledMatch* nearest = nullptr;
  for (const SampledMatch& one : sample.matches) {
    valid += one.zone != nullptr;
    if (!invertedElement(one)) continue;
    ++count;
    if (!nearest || one.deviation < nearest->deviation) nearest = &one;
  }
  if (!nearest) return std::nullopt;
  return invertedFinding(sample, *nearest, fmt::format("{} of {} matches", count, valid));
}

std::optional<SampledFinding> searchInverted(const RuleSample& sample) {
  constexpr std::size_t kStarts = 12;
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < sample.matches.size(); ++i) {
    if (!sample.matches[i].zone) continue;
    if (const auto turn = leastTurn(sample.matches[i].match)) order.push_back({*turn, i});
  }
  std::sort(order.begin(), order.end());
  RandomNumbers random(sample.index + 1);
  for (std::size_t i = 0; i < std::min(kStarts, order.size()); ++i)
    if (const auto found = flattened(sample, sample.matches[order[i].second], random))
      return invertedFinding(sample, *found, "a few matches");
  return std::nullopt;
}

}  // namespace af2::dsl
