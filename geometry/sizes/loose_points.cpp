#include "geometry/sizes/loose_points.h"

#include <algorithm>
#include <limits>

#include "geometry/base/box_tree.h"

namespace af2::geometry {

namespace {

double distanceTo(const std::pair<Point3, Point3>& chord, const Point3& p) {
  const Point3 along = chord.second - chord.first;
  const double square = dot(along, along);
  const double within =
      square > 0 ? std::clamp(dot(p - chord.first, along) / square, 0.0, 1.0) : 0.0;
  return distance(p, chord.first + within * along);
}

}  // namespace

std::vector<SizeSource> roomAround(std::span<const Point3> points,
                                   std::span<const std::pair<Point3, Point3>> chords) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<Box3> boxes;
  for (const Point3& p : points) boxes.emplace_back().add(p);
  for (const auto& [from, to] : chords) {
    Box3& box = boxes.emplace_back();
    box.add(from);
    box.add(to);
  }
  const BoxTree tree(boxes);
  std::vector<SizeSource> sources;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto room = [&](std::size_t k) {
      if (k == i) return kFar;
      return k < points.size() ? distance(points[i], points[k])
                               : distanceTo(chords[k - points.size()], points[i]);
    };
    const std::uint32_t nearest =
        tree.nearest(points[i], kFar, [&](std::uint32_t k) { return room(k); });
    if (nearest != BoxTree::kNone && room(nearest) > 0)
      sources.push_back({points[i], room(nearest)});
  }
  return sources;
}

}  // namespace af2::geometry
