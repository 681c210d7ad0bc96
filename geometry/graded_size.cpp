#include "geometry/graded_size.h"

#include <algorithm>
#include <cmath>

namespace af2::geometry {

namespace {

/// Segments come out up to a third shorter than wanted, to divide an edge evenly; that needs no
/// grading.
constexpr double kShort = 0.6;

/// A segment that is so many times longer than wanted is far too long; a division from outside may
/// have such.
constexpr double kLong = 2;

/// How fast sizes may shrink away from long segments, per unit of length: the next element is then
/// about two thirds as large.
constexpr double kShrinking = 1;

/// A source may be left out if the others around it want no more than this times its size there.
constexpr double kThinning = 1.3;

double largestWanted(const FrontInput& boundary, const SizeField& wanted) {
  double largest = 0;
  for (const auto& loop : boundary.loops)
    for (const BoundaryCorner& corner : loop)
      largest = std::max(largest, wanted.sizeAt(corner.point));
  return largest;
}

/// Keeps every second source or so of an evenly divided edge: the smallest first, in order.
std::vector<SizeSource> thinned(std::vector<SizeSource> sources, double growth) {
  std::stable_sort(sources.begin(), sources.end(),
                   [](const SizeSource& a, const SizeSource& b) { return a.size < b.size; });
  std::vector<SizeSource> kept;
  for (const SizeSource& s : sources) {
    // Neighbours along a loop were added shortly before, so a look at the last ones is enough.
    const std::size_t from = kept.size() > 16 ? kept.size() - 16 : 0;
    bool covered = false;
    for (std::size_t i = from; i < kept.size() && !covered; ++i)
      covered =
          kept[i].size + growth * distance(kept[i].position, s.position) <= kThinning * s.size;
    if (!covered) kept.push_back(s);
  }
  return kept;
}

/// Sources with negative sizes, so that the smallest of them is the longest segment.
std::vector<SizeSource> longSegments(const FrontInput& boundary, const SizeField& wanted) {
  std::vector<SizeSource> sources;
  for (const auto& loop : boundary.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const SurfacePoint &from = loop[i].point, &to = loop[(i + 1) % loop.size()].point;
      const double segment = distance(from.position, to.position);
      if (segment < kLong * std::max(wanted.sizeAt(from), wanted.sizeAt(to))) continue;
      sources.push_back({0.5 * (from.position + to.position), -segment});
    }
  }
  return sources;
}

}  // namespace

std::vector<SizeSource> shortSegments(const FrontInput& boundary, const SizeField& wanted) {
  std::vector<SizeSource> sources;
  for (const auto& loop : boundary.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const SurfacePoint& here = loop[i].point;
      const Point3& before = loop[(i + loop.size() - 1) % loop.size()].point.position;
      const Point3& after = loop[(i + 1) % loop.size()].point.position;
      // The geometric mean: beside a much longer neighbour, a tiny segment counts for less.
      const double spacing =
          std::sqrt(distance(before, here.position) * distance(here.position, after));
      if (spacing > 0 && spacing < kShort * wanted.sizeAt(here))
        sources.push_back({here.position, spacing});
    }
  }
  return sources;
}

GradedSize::GradedSize(const SizeField& wanted, const FrontInput& boundary, double growth)
    : wanted_(wanted),
      growing_(thinned(shortSegments(boundary, wanted), growth), growth,
               largestWanted(boundary, wanted)),
      shrinking_(longSegments(boundary, wanted), kShrinking, 0) {}

double GradedSize::sizeAt(const SurfacePoint& point) const {
  double size = wanted_.sizeAt(point);
  if (!shrinking_.isEmpty()) size = std::max(size, -shrinking_.at(point.position));
  if (!growing_.isEmpty()) size = std::min(size, growing_.at(point.position));
  return size;
}

}  // namespace af2::geometry
