#include "engine/run/region_elements.h"

#include <cmath>

#include "engine/base/constants.h"
#include "engine/base/error.h"
#include "engine/run/region_loops.h"

namespace af2::region {
namespace {

/// The elements beside a boundary that is finer than what is inside: sizes grow from it inwards.
class FineBoundary {
 public:
  /// inside  the size away from the boundary
  /// reach   the distance from the boundary to the middle of the region
  FineBoundary(const Plane& plane, bool isReversed, const SurfaceEvaluator& surface,
               const SizeField& size, double inside, double reach)
      : plane_(plane),
        isReversed_(isReversed),
        surface_(surface),
        size_(size),
        inside_(inside),
        reach_(reach) {}

  /// Beside one edge, those that are there only because sizes are smaller than inside.
  double elementsAt(const BoundaryCorner& from, const BoundaryCorner& to) const {
    const Point2 start = plane_.at(from), along = plane_.at(to) - start;
    const double edge = length(along);
    if (!(edge > 0)) return 0;
    const Point2 left{-along.y / edge, along.x / edge};
    const Point2 inwards = isReversed_ ? -1 * left : left;
    double sum = 0, before = 0, sizeBefore = size_.sizeAt(from.point);
    // Sizes grow by a share of the distance, so twice the distance is about twice the size.
    for (double away = edge; sizeBefore < inside_ && before < reach_; away *= 2) {
      const double here = std::min(away, reach_);
      const Point2 p = start + 0.5 * along + here * inwards;
      const double sizeHere =
          std::min(size_.sizeAt(surface_.at(p.x / plane_.scaleU, p.y / plane_.scaleV)), inside_);
      if (!(sizeHere > 0)) break;  // no size outside of the region
      // The integral of 1 / size^2 where the size is linear.
      sum += (here - before) * (1 / (sizeBefore * sizeHere) - 1 / (inside_ * inside_));
      before = here;
      sizeBefore = sizeHere;
    }
    return edge * sum / kUnitTriangle;
  }

 private:
  const Plane& plane_;
  bool isReversed_;
  const SurfaceEvaluator& surface_;
  const SizeField& size_;
  double inside_, reach_;
};

}  // namespace

double expectedElements(const Loops& loops, const Plane& plane, bool isReversed,
                        const SurfaceEvaluator& surface, const SizeField& size, double many) {
  double area = 0, lengths = 0, perimeter = 0;
  std::size_t edges = 0;
  for (const Loop& loop : loops) area += signedArea(loop, plane);
  forEachEdge(loops, [&](const BoundaryCorner& c, const BoundaryCorner& d) {
    const double length = distance(c.point.position, d.point.position);
    lengths += length * size.sizeAt(c.point);
    perimeter += length;
    ++edges;
  });
  if (!(perimeter > 0) || !(lengths > 0)) return std::abs(area) / kUnitTriangle;
  const double mean = lengths / perimeter;
  const double inside = std::abs(area) / (kUnitTriangle * mean * mean);

  // With usual growth an edge has some ten elements beside it.
  constexpr double kMostBesideAnEdge = 100;
  if (kMostBesideAnEdge * static_cast<double>(edges) < many) return inside;
  const FineBoundary fine(plane, isReversed, surface, size, mean, 2 * std::abs(area) / perimeter);
  constexpr std::size_t kLookedAt = 200;
  const std::size_t every = std::max<std::size_t>(1, edges / kLookedAt);
  double beside = 0;
  std::size_t edge = 0;
  try {
    forEachEdge(loops, [&](const BoundaryCorner& c, const BoundaryCorner& d) {
      if (edge++ % every == 0) beside += fine.elementsAt(c, d);
    });
  } catch (const GeometryError&) {
    return inside;  // no surface beside the boundary
  }
  return inside + beside * static_cast<double>(every);
}

}  // namespace af2::region
