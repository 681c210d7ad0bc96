#include "geometry/boundary_crossings.h"

#include <algorithm>

#include "engine/predicates.h"

namespace af2::geometry {

namespace {

struct Segment {
  SegmentPlace place;
  VertexId from, to;
  Point2 p, q;
  double low() const { return std::min(p.x, q.x); }
  double high() const { return std::max(p.x, q.x); }
};

std::vector<Segment> segmentsOf(const FrontInput& boundary,
                                const std::function<Point2(const SurfacePoint&)>& inPlane) {
  std::vector<Segment> segments;
  for (std::size_t l = 0; l < boundary.loops.size(); ++l) {
    const auto& loop = boundary.loops[l];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const BoundaryCorner &a = loop[i], &b = loop[(i + 1) % loop.size()];
      segments.push_back({{l, i}, a.vertex, b.vertex, inPlane(a.point), inPlane(b.point)});
    }
  }
  return segments;
}

/// Segments with a common vertex only meet elsewhere if they overlap; a line inside the region is
/// there in both directions.
bool cross(const Segment& a, const Segment& b) {
  const bool same = a.from == b.from && a.to == b.to, opposite = a.from == b.to && a.to == b.from;
  if (same || opposite) return false;
  const auto overlaps = [](Point2 apex, Point2 one, Point2 other) {
    return orientation(apex, one, other) == Turn::Straight && dot(one - apex, other - apex) > 0;
  };
  if (a.from == b.from) return overlaps(a.p, a.q, b.q);
  if (a.from == b.to) return overlaps(a.p, a.q, b.p);
  if (a.to == b.from) return overlaps(a.q, a.p, b.q);
  if (a.to == b.to) return overlaps(a.q, a.p, b.p);
  const bool apart = std::max(a.p.y, a.q.y) < std::min(b.p.y, b.q.y) ||
                     std::max(b.p.y, b.q.y) < std::min(a.p.y, a.q.y);
  return !apart && segmentsMeet(a.p, a.q, b.p, b.q);
}

}  // namespace

std::vector<std::pair<SegmentPlace, SegmentPlace>> crossingsOf(
    const FrontInput& boundary, const std::function<Point2(const SurfacePoint&)>& inPlane,
    std::size_t limit) {
  std::vector<Segment> segments = segmentsOf(boundary, inPlane);
  std::stable_sort(segments.begin(), segments.end(),
                   [](const Segment& a, const Segment& b) { return a.low() < b.low(); });
  std::vector<std::pair<SegmentPlace, SegmentPlace>> found;
  std::vector<const Segment*> open;  // those that the sweep has not left behind
  for (const Segment& segment : segments) {
    std::erase_if(open, [&](const Segment* s) { return s->high() < segment.low(); });
    for (const Segment* other : open) {
      if (found.size() >= limit) return found;
      if (cross(segment, *other)) found.emplace_back(other->place, segment.place);
    }
    open.push_back(&segment);
  }
  return found;
}

}  // namespace af2::geometry
