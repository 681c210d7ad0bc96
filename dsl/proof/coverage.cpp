#include "dsl/proof/coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dsl/proof/rule_sample.h"
#include "dsl/proof/test_text.h"
#include "engine/base/elementary.h"
#include "engine/base/predicates.h"

namespace af2::dsl {
namespace {

constexpr double kDegree = M_PI / 180;

/// Lengths from low to high in geometric progression.
std::vector<double> lengths(double low, double high, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    const double length = low * af2::power(high / low, static_cast<double>(i) / (count - 1));
    values.push_back(std::round(length * 1000) / 1000);
  }
  return values;
}

std::vector<double> angles() {
  std::vector<double> values;
  for (int degrees = 15; degrees < 360; degrees += 15) values.push_back(degrees);
  return values;
}

/// Rounds to few digits, so that a situation is easy to describe.
Point2 polar(double degrees, double radius) {
  const auto round = [](double x) { return std::round(x * 1000) / 1000 + 0.0; };
  return {round(radius * af2::cosine(degrees * kDegree)),
          round(radius * af2::sine(degrees * kDegree))};
}

FrontPiece chainOf(std::vector<Point2> vertices, std::size_t base) {
  FrontPiece piece;
  std::vector<std::size_t> chain;
  for (std::size_t i = 0; i < vertices.size(); ++i) chain.push_back(i);
  piece.vertices = std::move(vertices);
  piece.chains = {chain};
  piece.base = {base, base + 1};
  return piece;
}

FrontPiece oneEdge(double length) { return chainOf({{0, 0}, {length, 0}}, 0); }

/// a -> b -> c with a free angle at b.
FrontPiece twoEdges(double angle, double length) {
  return chainOf({{0, 0}, {1, 0}, Point2{1, 0} + polar(180 - angle, length)}, 0);
}

/// d -> a -> b -> c with free angles at b and a.
FrontPiece threeEdges(double angleB, double angleA) {
  return chainOf({polar(angleA, 1), {0, 0}, {1, 0}, Point2{1, 0} + polar(180 - angleB, 1)}, 1);
}

/// Whether edges of a chain cross, or touch other than at a common vertex.
bool isPossible(const FrontPiece& piece) {
  const auto& v = piece.vertices;
  if (v.size() == 4 && segmentsMeet(v[0], v[1], v[2], v[3])) return false;
  for (std::size_t i = 2; i < v.size(); ++i)
    if (orientation(v[i - 2], v[i - 1], v[i]) == Turn::Straight &&
        dot(v[i - 1] - v[i - 2], v[i] - v[i - 1]) < 0)
      return false;
  return true;
}

int lowestLevel(SingleStepper& stepper, FrontPiece piece, int lastLevel) {
  if (!isPossible(piece)) return CoverageMap::kImpossible;
  for (piece.level = 1; piece.level <= lastLevel; ++piece.level)
    if (stepper.chosenRule(piece)) return piece.level;
  return CoverageMap::kNone;
}

/// Whether a rule would be chosen at this level if its score were accepted.
bool isRefusedByScore(SingleStepper& stepper, FrontPiece piece, int level) {
  piece.level = level;
  return std::ranges::any_of(stepper.take(piece).refusals, [](const RuleRefusal& refusal) {
    return refusal.reason == Refusal::Score;
  });
}

/// Whether no rule accepts an ordinary situation.
bool isLeftOut(const CoverageMap& map, std::size_t i) {
  return map.isOrdinary[i] && map.levels[i] == CoverageMap::kNone;
}

template <class MakePiece>
CoverageMap mapOf(SingleStepper& stepper, int lastLevel, CoverageMap map, const MakePiece& make) {
  for (const double y : map.ys)
    for (const double x : map.xs) {
      map.pieces.push_back(make(x, y));
      map.levels.push_back(lowestLevel(stepper, map.pieces.back(), lastLevel));
      map.isOrdinary.push_back(isOrdinary(map.pieces.back()));
      map.isRefusedByScore.push_back(isLeftOut(map, map.levels.size() - 1) &&
                                     isRefusedByScore(stepper, map.pieces.back(), lastLevel));
    }
  return map;
}

std::string testOf(const FrontPiece& piece, const std::string& title, int level) {
  const std::vector<std::string> names = piece.vertices.size() == 4
                                             ? std::vector<std::string>{"d", "a", "b", "c"}
                                             : std::vector<std::string>{"a", "b", "c"};
  std::string front;
  for (std::size_t i = 0; i < piece.vertices.size(); ++i)
    front += fmt::format("{}{} ({}, {})", i == 0 ? "" : " -> ", names[i],
                         shortest(piece.vertices[i].x), shortest(piece.vertices[i].y));
  return fmt::format(
      "test \"{}\" {{\n  front {};\n  base a -> b;\n  class {};\n  expect not stuck;\n}}\n", title,
      front, level);
}

/// A situation in the middle of a row of uncovered ones, so that it is not a borderline case.
std::size_t typicalGap(const CoverageMap& map) {
  std::size_t best = 0, longest = 0;
  const std::size_t columns = map.xs.size();
  for (std::size_t row = 0; row < map.ys.size(); ++row)
    for (std::size_t x = 0, begin = 0; x <= columns; ++x) {
      if (x < columns && isLeftOut(map, row * columns + x)) continue;
      if (x - begin > longest) {
        longest = x - begin;
        best = row * columns + begin + longest / 2;
      }
      begin = x + 1;
    }
  return best;
}

/// The share of the ordinary situations that are uncovered.
double shareLeftOut(const CoverageMap& map) {
  double ordinary = 0, leftOut = 0;
  for (std::size_t i = 0; i < map.levels.size(); ++i) {
    ordinary += map.isOrdinary[i];
    leftOut += isLeftOut(map, i);
  }
  return ordinary > 0 ? leftOut / ordinary : 0;
}

}  // namespace

Coverage measureCoverage(const RuleSet& rules, int lastLevel) {
  Coverage coverage;
  coverage.lastLevel = std::min(lastLevel, rules.maxLevel());
  SingleStepper stepper(rules);
  const auto add = [&](CoverageMap grid, const auto& make) {
    coverage.maps.push_back(mapOf(stepper, coverage.lastLevel, std::move(grid), make));
  };
  add({"one edge", "length of the edge", "", lengths(0.3, 3, 46), {0}, {}, {}, {}},
      [](double length, double) { return oneEdge(length); });
  add({"two edges",
       "free angle at b",
       "length of the second edge",
       angles(),
       lengths(0.4, 2.5, 12),
       {},
       {},
       {}},
      twoEdges);
  add({"three edges", "free angle at b", "free angle at a", angles(), angles(), {}, {}, {}},
      threeEdges);
  coverage.closure = measureClosure(rules);
  return coverage;
}

bool isOrdinary(const FrontPiece& piece) {
  constexpr double kShortest = 0.6, kLongest = 1.7, kMinGap = 0.5;
  if (!isPossible(piece)) return false;
  const auto& v = piece.vertices;
  for (std::size_t i = 0; i + 1 < v.size(); ++i) {
    const double size = distance(v[i], v[i + 1]);
    if (size < kShortest || size > kLongest) return false;
    for (std::size_t j = i + 2; j < v.size(); ++j)
      if (distance(v[i], v[j]) < kMinGap) return false;
  }
  for (std::size_t i = 1; i + 1 < v.size(); ++i) {
    const Point2 back = v[i - 1] - v[i], ahead = v[i + 1] - v[i];
    const double turn = std::abs(af2::angleOf({dot(ahead, back), cross(ahead, back)}));
    if (turn < 44.5 * kDegree) return false;
  }
  return true;
}

std::optional<SampledFinding> findUncoveredSituations(const Coverage& coverage) {
  constexpr double kTolerable = 0.01;
  std::string shares;
  SampledFinding finding(Code::UncoveredSituation);
  double worst = 0;
  bool isScoreAtFault = true;  // in each of the situations that are shown
  for (const CoverageMap& map : coverage.maps) {
    const double share = shareLeftOut(map);
    if (share <= kTolerable) continue;
    shares += fmt::format("{}{} of {}", shares.empty() ? "" : ", ", percent(share), map.title);
    const std::size_t gap = typicalGap(map);
    const FrontPiece& piece = map.pieces[gap];
    isScoreAtFault = isScoreAtFault && map.isRefusedByScore[gap];
    const std::string test = testOf(piece, "a rule takes " + map.title, coverage.lastLevel);
    if (share > worst) finding.example = {piece.vertices, coverage.lastLevel, {}, {}};
    worst = std::max(worst, share);
    if (finding.test.empty())
      finding.test = test;
    else
      finding.furtherTests.push_back(test);
  }
  if (shares.empty()) return std::nullopt;
  finding.message = fmt::format("no rule takes some ordinary pieces of front up to level {}: {}",
                                coverage.lastLevel, shares);
  finding.help =
      isScoreAtFault
          ? "add a rule for them, or let the bound of `accept` grow faster with the level"
          : "add a rule for them, or loosen the tolerances or the zone of one that is near";
  return finding;
}

}  // namespace af2::dsl
