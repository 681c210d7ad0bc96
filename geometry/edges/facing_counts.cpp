#include "geometry/edges/facing_counts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "geometry/base/box_tree.h"
#include "geometry/base/disjoint_sets.h"
#include "geometry/base/nearest_on_segment.h"

namespace af2::geometry {

namespace {

/// Between segments that face each other, in lengths of one of them.
constexpr double kFarthest = 1.5;

/// The segments of one count.
struct Side {
  std::vector<Point3> points;
  std::vector<Box3> boxes;  ///< [i] from point i to the next
  Box3 box;
  double longest = 0;

  void add(const Point3& point) {
    if (!points.empty()) {
      Box3& segment = boxes.emplace_back();
      segment.add(points.back());
      segment.add(point);
      longest = std::max(longest, distance(points.back(), point));
    }
    points.push_back(point);
    box.add(point);
  }
};

bool areAcross(const Point3& way, const Point3& along) {
  constexpr double kSlanting = 0.5;  // most cosine between an edge and the way across
  return std::abs(dot(way, along)) <= kSlanting * length(way) * length(along);
}

/// Whether all segments of `one` but one at a mitre have `other` in front of them.
bool isInFrontOf(const Side& other, const Side& one) {
  constexpr std::size_t kMost = 1;  // of segments that may be alone
  const BoxTree tree(other.boxes);
  std::size_t alone = 0;
  for (std::size_t i = 0; i + 1 < one.points.size() && alone <= kMost; ++i) {
    const Point3 along = one.points[i + 1] - one.points[i];
    const Point3 middle = one.points[i] + 0.5 * along;
    const auto wayTo = [&](std::uint32_t k) {
      return nearestOnSegment(middle, other.points[k], other.points[k + 1]) - middle;
    };
    const std::uint32_t nearest = tree.nearest(middle, kFarthest * length(along),
                                               [&](std::uint32_t k) { return length(wayTo(k)); });
    const bool isFacing =
        nearest != BoxTree::kNone && areAcross(wayTo(nearest), along) &&
        areAcross(wayTo(nearest), other.points[nearest + 1] - other.points[nearest]);
    if (!isFacing) ++alone;
  }
  return alone <= kMost;
}

bool areFacing(const Side& one, const Side& other) {
  constexpr std::size_t kFewest = 3;  // of segments: less is hardly a strip
  return std::min(one.boxes.size(), other.boxes.size()) >= kFewest && isInFrontOf(other, one) &&
         isInFrontOf(one, other);
}

}  // namespace

FacingEdges::FacingEdges(const DividedEdges& divided)
    : divided_(divided), parts_(divided.counts.size()) {
  for (std::size_t e = 0; e < divided.edges.size(); ++e) {
    const DividedEdge& edge = divided.edges[e];
    std::size_t first = 0;
    for (std::size_t part = 0; part < edge.counts.size(); ++part) {
      const std::size_t last = part < edge.stops.size() ? edge.stops[part] : edge.points.size() - 1;
      parts_[edge.counts[part]] = {e, first, last};
      first = last;
    }
  }
}

std::vector<FacingPair> FacingEdges::around(const std::vector<std::size_t>& ofFace) const {
  std::vector<Side> sides(ofFace.size());
  std::vector<Box3> boxes;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const auto& [edge, first, last] = parts_[ofFace[s]];
    for (std::size_t i = first; first < last && i <= last; ++i)
      sides[s].add(divided_.points[divided_.edges[edge].points[i]]);
    boxes.push_back(sides[s].box);
  }
  const BoxTree tree(boxes);
  std::vector<FacingPair> pairs;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const double reach = kFarthest * sides[s].longest;
    const Point3 by{reach, reach, reach};
    tree.forEachIn(Box3{boxes[s].low - by, boxes[s].high + by}, [&](std::uint32_t other) {
      if (s < other && areFacing(sides[s], sides[other]))
        pairs.emplace_back(ofFace[s], ofFace[other]);
    });
  }
  return pairs;
}

std::vector<FacingCounts> matchFacing(const std::vector<FacingPair>& pairs,
                                      std::vector<SegmentCount>& counts) {
  constexpr double kMost = 1.25;  // of the number of segments without it
  DisjointSets strips(counts.size());
  for (const auto& [one, other] : pairs)
    strips.join(static_cast<std::uint32_t>(one), static_cast<std::uint32_t>(other));
  std::map<std::uint32_t, FacingCounts> byStrip;
  for (std::uint32_t i = 0; i < counts.size(); ++i) byStrip[strips.of(i)].push_back(i);
  std::vector<FacingCounts> facing;
  for (auto& [strip, sides] : byStrip) {
    if (sides.size() < 2) continue;
    std::size_t most = 0;
    for (const std::size_t i : sides) most = std::max(most, counts[i].segments);
    std::erase_if(sides, [&](std::size_t i) {
      const auto few = static_cast<double>(counts[i].segments);
      return counts[i].segments < most &&
             (counts[i].isFixed || static_cast<double>(most) > kMost * few);
    });
    for (const std::size_t i : sides) {
      if (counts[i].segments < most) counts[i].wanted = static_cast<double>(most);
      counts[i].segments = most;
    }
    if (sides.size() > 1) facing.push_back(std::move(sides));
  }
  return facing;
}

}  // namespace af2::geometry
