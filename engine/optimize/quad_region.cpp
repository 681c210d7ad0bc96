#include "engine/optimize/quad_region.h"

#include <algorithm>

#include "engine/optimize/ideal_angles.h"

namespace af2 {

void QuadRegion::clear() {
  for (const std::size_t e : elements_) isIn_[e] = 0;
  elements_.clear();
}

void QuadRegion::add(std::size_t element) {
  if (element >= isIn_.size()) isIn_.resize(topology_.mesh().elements.size(), 0);
  if (isIn_[element]) return;
  isIn_[element] = 1;
  elements_.push_back(element);
}

void QuadRegion::addStar(VertexId v) {
  topology_.forEachCornerOf(v, [&](Corner c) { add(c.element()); });
}

void QuadRegion::addLayer() {
  for (const Corner side : outline_) addStar(topology_.vertexAt(side));
}

void QuadRegion::findOutline() {
  outline_.clear();
  for (const std::size_t e : elements_)
    for (std::size_t i = 0; i < 4; ++i) {
      const Corner beyond = topology_.across(Corner(e, i));
      if (beyond.isNone() || !has(beyond.element())) outline_.push_back(Corner(e, i));
    }
}

/// Number of quadrilaterals in the region with which the vertex would be regular.
int QuadRegion::wantedInside(const Place& place) const {
  const int wanted = editor_.wantedAt(place.vertex);
  return std::max(1, (wanted + kRightAngle / 2) / kRightAngle) - place.outside;
}

QuadRegion::Growth QuadRegion::growOnce() {
  for (const std::size_t e : elements_)
    if (!topology_.mesh().elements[e].isQuad()) return Growth::Impossible;
  findOutline();
  std::vector<VertexId> toGrow;
  for (const Corner side : outline_) {
    Place place{topology_.vertexAt(side), 0};
    int all = 0;
    topology_.forEachCornerOf(place.vertex, [&](Corner c) {
      ++all;
      place.outside += has(c.element()) ? 0 : 1;
    });
    if (all != topology_.valence(place.vertex)) return Growth::Impossible;  // on a seam
    const int inside = wantedInside(place);
    if (inside == 1 || inside == 2) continue;
    if (place.outside == 0) return Growth::Impossible;
    toGrow.push_back(place.vertex);
  }
  for (const VertexId v : toGrow) addStar(v);
  return toGrow.empty() ? Growth::Done : Growth::More;
}

bool QuadRegion::makeConvex() {
  for (;;) {
    if (elements_.size() > mostElements_) return false;
    const Growth growth = growOnce();
    if (growth != Growth::More) return growth == Growth::Done;
  }
}

std::optional<RegionRing> QuadRegion::ring() const {
  RegionRing ring;
  // Follows the outline: at each vertex of a ring, one side begins.
  std::vector<std::pair<VertexId, VertexId>> sides;
  for (const Corner c : outline_)
    sides.emplace_back(topology_.vertexAt(c), topology_.vertexAt(topology_.next(c)));
  std::ranges::sort(sides);
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i].first == sides[i - 1].first) return std::nullopt;
  VertexId v = topology_.vertexAt(outline_.front());
  do {
    const auto side = std::ranges::lower_bound(sides, v, {}, &std::pair<VertexId, VertexId>::first);
    if (side == sides.end() || side->first != v || ring.vertices.size() == sides.size())
      return std::nullopt;
    Place place{v, 0};
    topology_.forEachCornerOf(v, [&](Corner c) { place.outside += has(c.element()) ? 0 : 1; });
    if (wantedInside(place) == 1) ring.corners.push_back(ring.vertices.size());
    ring.vertices.push_back(v);
    v = side->second;
  } while (v != ring.vertices.front());
  if (ring.vertices.size() != sides.size()) return std::nullopt;
  return ring;
}

}  // namespace af2
