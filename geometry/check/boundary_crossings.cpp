#include "geometry/check/boundary_crossings.h"

#include "engine/base/predicates.h"
#include "geometry/base/box_tree.h"

namespace af2::geometry {

namespace {

struct Segment {
  SegmentPlace place;
  VertexId from, to;
  Point2 p, q;
  Box3 box() const {
    Box3 box;
    box.add(Point3{p.x, p.y, 0});
    box.add(Point3{q.x, q.y, 0});
    return box;
  }
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
  return segmentsMeet(a.p, a.q, b.p, b.q);
}

}  // namespace

std::vector<std::pair<SegmentPlace, SegmentPlace>> crossingsOf(
    const FrontInput& boundary, const std::function<Point2(const SurfacePoint&)>& inPlane,
    std::size_t limit) {
  const std::vector<Segment> segments = segmentsOf(boundary, inPlane);
  std::vector<Box3> boxes;
  boxes.reserve(segments.size());
  for (const Segment& segment : segments) boxes.push_back(segment.box());
  const BoxTree tree(boxes);
  std::vector<std::pair<SegmentPlace, SegmentPlace>> found;
  for (std::uint32_t i = 0; i < segments.size() && found.size() < limit; ++i)
    tree.forEachIn(boxes[i], [&](std::uint32_t k) {
      if (k < i && found.size() < limit && cross(segments[k], segments[i]))
        found.emplace_back(segments[k].place, segments[i].place);
    });
  return found;
}

}  // namespace af2::geometry
