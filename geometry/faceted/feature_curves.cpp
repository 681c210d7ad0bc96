#include "geometry/faceted/feature_curves.h"

#include <algorithm>
#include <utility>

#include "engine/base/elementary.h"

namespace af2::geometry {

FeatureCurves::FeatureCurves(const std::vector<Point3>& vertices, const std::set<FacetEdge>& edges,
                             double angle, const std::vector<double>& speckAt)
    : vertices_(vertices), angle_(angle), speckAt_(speckAt) {
  for (const auto& [a, b] : edges) {
    beside_[a].push_back(b);
    beside_[b].push_back(a);
  }
  for (const auto& [v, others] : beside_)
    if (isCorner(v))
      for (const std::uint32_t other : others) follow(v, other);
  for (const auto& [v, others] : beside_) follow(v, others.front());  // what is closed
}

/// Curves that go back and forth within less than a speck do not turn.
bool FeatureCurves::isCorner(std::uint32_t v) const {
  const std::vector<std::uint32_t>& others = beside_.at(v);
  if (others.size() != 2) return true;
  if (!(angleBetween(at(v) - at(others[0]), at(others[1]) - at(v)) > angle_)) return false;
  const Point3 before = at(v) - at(beyondSpeck(v, others[0]));
  return angleBetween(before, at(beyondSpeck(v, others[1])) - at(v)) > angle_;
}

/// The first vertex from `next` on that is farther from `from` than a speck.
std::uint32_t FeatureCurves::beyondSpeck(std::uint32_t from, std::uint32_t next) const {
  std::uint32_t before = from;
  while (distance(at(from), at(next)) < speckAt_[from]) {
    const std::vector<std::uint32_t>& others = beside_.at(next);
    if (others.size() != 2) break;
    const std::uint32_t after = others[0] == before ? others[1] : others[0];
    if (after == from) break;
    before = next;
    next = after;
  }
  return next;
}

void FeatureCurves::follow(std::uint32_t from, std::uint32_t to) {
  if (places_.contains(std::minmax(from, to))) return;
  FeatureCurve curve{from};
  while (true) {
    places_[std::minmax(from, to)] = {curves_.size(), curve.size() - 1, from};
    curve.push_back(to);
    if (to == curve.front() || isCorner(to)) break;
    const std::vector<std::uint32_t>& others = beside_.at(to);
    const std::uint32_t next = others[0] == from ? others[1] : others[0];
    from = to;
    to = next;
  }
  curves_.push_back(std::move(curve));
}

}  // namespace af2::geometry
