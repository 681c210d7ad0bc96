#include "dsl/match/match_sampler.h"

#include <algorithm>
#include <cmath>

namespace af2::dsl {

double RandomNumbers::unit() {
  state_ += 0x9e3779b97f4a7c15u;
  std::uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  z ^= z >> 31;
  return static_cast<double>(z >> 11) * 0x1p-53;
}

Point2 RandomNumbers::inDisc() {
  while (true) {
    const Point2 p{between(-1, 1), between(-1, 1)};
    if (dot(p, p) <= 1) return p;
  }
}

MatchSampler::MatchSampler(const RuleSet& rules, const AF2Rule& rule, int level, std::uint64_t seed)
    : rules_(rules),
      rule_(rule),
      level_(level),
      tolerance_(rules.matchTolerance(level)),
      random_(seed) {}

/// A deviation with xx dx^2 + xy dx dy + yy dy^2 <= tolerance. The Cholesky factor of the form maps
/// a disc to this ellipse. For forms without such a factor, the pattern test that follows removes
/// deviations that are too large.
Point2 MatchSampler::draw(const PatternVertex& vertex) {
  const Point2 p = random_.inDisc(), reference = vertex.reference.at(level_);
  if (!vertex.tolerance) return reference + kFarthestVertex * p;
  const ToleranceForm& w = vertex.tolerance->at(level_);
  const double smallest = tolerance_ / (16 * kFarthestVertex * kFarthestVertex);
  const double xx = std::max(w.xx, smallest);
  const double yy = std::max(w.yy - 0.25 * w.xy * w.xy / xx, smallest);
  const double dy = std::sqrt(tolerance_ / yy) * p.y;
  const double dx = std::sqrt(tolerance_ / xx) * p.x - 0.5 * w.xy / xx * dy;
  return reference + Point2{dx, dy};
}

/// Within reach of the computed place; vertices to come are at their references.
Point2 MatchSampler::drawNear(const NearPlace& near, std::vector<Point2> vertices) {
  for (std::size_t i = vertices.size(); i < rule_.definition().vertices.size(); ++i)
    vertices.push_back(rule_.definition().vertices[i].reference.at(level_));
  const PatternMatch match(rule_, std::move(vertices), level_);
  const Point2 place = near.place->transformPoint(match.binding()).value_or(Point2{0.5, 1});
  return place + near.reach.at(level_) * random_.inDisc();
}

double MatchSampler::drawBase() {
  const bool isScaled = rules_.definition().unit == ChartUnit::BaseLength;
  return isScaled ? 1 : random_.between(kShortestBase, kLongestBase);
}

std::optional<PatternMatch> MatchSampler::next() {
  constexpr int kTries = 2000;
  if (!rule_.appliesAt(level_)) return std::nullopt;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    std::vector<Point2> vertices{{0, 0}, {drawBase(), 0}};
    const auto& pattern = rule_.definition().vertices;
    for (std::size_t i = 2; i < pattern.size(); ++i)
      vertices.push_back(pattern[i].near ? drawNear(*pattern[i].near, vertices) : draw(pattern[i]));
    PatternMatch match(rule_, std::move(vertices), level_);
    if (match.refusalOfMatch(rules_) == Refusal::None) return match;
  }
  return std::nullopt;
}

double deviationOf(const PatternMatch& match) {
  double sum = 0;
  for (std::size_t i = 0; i < match.vertices().size(); ++i) {
    const Point2 d =
        match.vertices()[i] - match.rule().definition().vertices[i].reference.at(match.level());
    sum += dot(d, d);
  }
  return sum;
}

}  // namespace af2::dsl
