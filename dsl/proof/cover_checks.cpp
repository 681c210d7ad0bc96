// Z1: are all elements inside the free zone?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dsl/proof/rule_sample.h"
#include "dsl/proof/test_text.h"
#include "dsl/proof/zone_depth.h"
#include "engine/base/predicates.h"
#include "engine/mesh/element_shape.h"

namespace af2::dsl {
namespace {

struct Uncovered {
  const SampledMatch* match;
  int element;
  Point2 at;         // inside the element, outside of the zone
  double depth = 0;  // from `at` to the zone; measured for some
};

bool isUsable(const SampledMatch& one) { return one.zone && one.placed; }

std::optional<Uncovered> uncoveredElement(const SampledMatch& one) {
  const auto& elements = one.match.rule().definition().elements;
  std::optional<Uncovered> found;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const auto corners = cornersOf(elements[i], *one.placed);
    if (!turnsLeftEverywhere(corners)) return std::nullopt;  // this is reported as G2
    if (found) continue;
    if (const auto at = unseenPlace(*one.zone, corners))
      found = Uncovered{&one, static_cast<int>(i), *at};
  }
  return found;
}

/// The distance by which the element extends beyond the zone: the maximum over its corners and the
/// place that was found.
void measure(Uncovered& uncovered) {
  const SampledMatch& one = *uncovered.match;
  const MeasuredZone zone(*one.zone);
  uncovered.depth = zone.depthOutside(uncovered.at);
  const auto& elements = one.match.rule().definition().elements;
  const auto corners =
      cornersOf(elements[static_cast<std::size_t>(uncovered.element)], *one.placed);
  for (const Point2 corner : corners) {
    const double depth = zone.depthOutside(corner);
    if (depth <= uncovered.depth) continue;
    uncovered.depth = depth;
    uncovered.at = corner;
  }
}

bool holds(const std::vector<Point2>& corners, Point2 p) {
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i)
    if (orientation(corners[i], corners[(i + 1) % n], p) != Turn::Left) return false;
  return true;
}

/// A place with few digits inside the element and outside the zone, searched from the farthest
/// place towards the middle of the element.
std::optional<Point2> shownPlace(const Uncovered& uncovered) {
  const SampledMatch& one = *uncovered.match;
  const auto corners =
      cornersOf(one.match.rule().definition().elements[uncovered.element], *one.placed);
  Point2 middle{};
  for (const Point2 corner : corners)
    middle = middle + (1.0 / static_cast<double>(corners.size())) * corner;
  for (const double t : {0.3, 0.2, 0.1, 0.05, 0.02, 0.01, 0.001, 1e-4, 0.0}) {
    const Point2 p = uncovered.at + t * (middle - uncovered.at);
    for (const double digits : {1e2, 1e3, 1e5, 1e8}) {
      const Point2 q{std::round(p.x * digits) / digits, std::round(p.y * digits) / digits};
      if (holds(corners, q) && !one.zone->contains(q, ZoneBoundary::Counts)) return q;
    }
  }
  return std::nullopt;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A clear and ordinary example: of the half with the larger depths, the match closest to the
/// reference.
const Uncovered& exampleOf(const std::vector<Uncovered>& all, double leastDepth) {
  const Uncovered* best = nullptr;
  for (const Uncovered& one : all)
    if (one.depth >= leastDepth && (!best || one.match->deviation < best->match->deviation))
      best = &one;
  return *best;
}

/// Outlines of curved zones are expensive to compute, so only a few are measured.
void measureSome(std::vector<Uncovered>& all) {
  constexpr std::size_t kCurvedMeasured = 12;
  const bool isCheap = isConvexPolygon(*all.front().match->zone);
  if (!isCheap && all.size() > kCurvedMeasured) all.resize(kCurvedMeasured);
  for (Uncovered& one : all) measure(one);
}

}  // namespace

std::optional<SampledFinding> findUncovered(const RuleSample& sample) {
  std::vector<Uncovered> all;
  std::size_t valid = 0;
  for (const SampledMatch& one : sample.matches) {
    if (!isUsable(one)) continue;
    ++valid;
    if (const auto uncovered = uncoveredElement(one)) all.push_back(*uncovered);
  }
  if (all.empty()) return std::nullopt;
  const double share = static_cast<double>(all.size()) / static_cast<double>(valid);

  measureSome(all);
  std::vector<double> depths;
  for (const Uncovered& one : all) depths.push_back(one.depth);
  const double middle = median(depths);
  const auto shows = [&](const SampledMatch& one) {
    auto uncovered = isUsable(one) ? uncoveredElement(one) : std::nullopt;
    if (!uncovered) return false;
    measure(*uncovered);
    return uncovered->depth > 0.5 * middle && shownPlace(*uncovered);
  };
  const SampledMatch match = simplified(*exampleOf(all, middle).match, sample.rules, shows);
  Uncovered example = *uncoveredElement(match);
  const Point2 surelyUnseen = example.at;
  measure(example);
  const Point2 unseen = shownPlace(example).value_or(surelyUnseen);
  SampledFinding finding = findingAbout(sample, Code::UncoveredElement);
  finding.element = example.element;
  finding.message = fmt::format(
      "a new element of rule '{}' extends beyond the free zone at {} of the matches at level "
      "{}: median distance {:.2g}, maximum {:.2g}",
      sample.name(), percent(share), sample.level, middle, *std::ranges::max_element(depths));
  finding.help = "an obstacle there would not be noticed; move the zone's corners outwards";
  finding.example = {match.match.vertices(), sample.level, {example.at}, {unseen}};
  finding.test = writeTest(
      match.match,
      {fmt::format("{}: an obstacle inside the new element is seen", sample.name()),
       {unseen},
       fmt::format("not rule \"{}\" because zone hit by vertex o or class", sample.name())});
  return finding;
}

}  // namespace af2::dsl
