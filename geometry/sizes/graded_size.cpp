#include "geometry/sizes/graded_size.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/sizes/sizes_at_corners.h"

namespace af2::geometry {

namespace {

/// Segments come out up to a third shorter than wanted, to divide an edge evenly; that needs no
/// grading.
constexpr double kShort = 0.6;

/// A segment that is this many times longer than wanted is far too long; given divisions may have
/// such segments.
constexpr double kLong = 2;

/// How fast sizes may shrink away from long segments, per unit of length: the next element is then
/// about two thirds as large.
constexpr double kShrinking = 1;

/// A source may be left out if the others around it want no more than this times its size there.
constexpr double kThinning = 1.3;

SizesAtCorners wantedAtCorners(const FrontInput& boundary, const SizeField& wanted) {
  SizesAtCorners sizes(boundary);
  for (std::size_t i = 0; i < sizes.count(); ++i)
    sizes.at(i).wanted = wanted.sizeAt(sizes.corner(i));
  return sizes;
}

double largestOf(SizesAtCorners& sizes) {
  double largest = 0;
  for (std::size_t i = 0; i < sizes.count(); ++i) largest = std::max(largest, sizes.at(i).wanted);
  return largest;
}

/// The corners at which the boundary is divided more finely than is wanted.
std::vector<SizeSource> shortSegments(const FrontInput& boundary, const SizesAtCorners& wanted) {
  std::vector<SizeSource> sources;
  for (std::size_t l = 0; l < boundary.loops.size(); ++l) {
    const auto& loop = boundary.loops[l];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Point3& here = loop[i].point.position;
      const Point3& before = loop[(i + loop.size() - 1) % loop.size()].point.position;
      const Point3& after = loop[(i + 1) % loop.size()].point.position;
      // The geometric mean: beside a much longer neighbour, a tiny segment counts for less.
      const double spacing = std::sqrt(distance(before, here) * distance(here, after));
      if (spacing > 0 && spacing < kShort * wanted.find(loop[i].point)->wanted)
        sources.push_back({here, spacing});
    }
  }
  return sources;
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
std::vector<SizeSource> longSegments(const FrontInput& boundary, const SizesAtCorners& wanted) {
  std::vector<SizeSource> sources;
  for (std::size_t l = 0; l < boundary.loops.size(); ++l) {
    const auto& loop = boundary.loops[l];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t next = (i + 1) % loop.size();
      const Point3 &from = loop[i].point.position, &to = loop[next].point.position;
      const double segment = distance(from, to);
      const auto wantedAt = [&](std::size_t k) { return wanted.find(loop[k].point)->wanted; };
      if (segment < kLong * std::max(wantedAt(i), wantedAt(next))) continue;
      sources.push_back({0.5 * (from + to), -segment});
    }
  }
  return sources;
}

}  // namespace

struct GradedSize::Slopes {
  GrowingSize growing;
  GrowingSize shrinking;  ///< of negated sizes
  SizesAtCorners corners;

  double graded(const SurfacePoint& point, double size) const {
    if (!shrinking.isEmpty()) size = std::max(size, -shrinking.at(point.position));
    if (!growing.isEmpty()) size = growing.at(point.position, size);
    return size;
  }
};

GradedSize::GradedSize(const SizeField& wanted, const FrontInput& boundary, double growth)
    : wanted_(wanted) {
  SizesAtCorners sizes = wantedAtCorners(boundary, wanted);
  GrowingSize growing(thinned(shortSegments(boundary, sizes), growth), growth, largestOf(sizes));
  GrowingSize shrinking(longSegments(boundary, sizes), kShrinking, 0);
  const auto slopes =
      std::make_shared<Slopes>(Slopes{std::move(growing), std::move(shrinking), std::move(sizes)});
  SizesAtCorners& corners = slopes->corners;
  for (std::size_t i = 0; i < corners.count(); ++i)
    corners.at(i).graded = slopes->graded(corners.corner(i), corners.at(i).wanted);
  slopes_ = slopes;
}

GradedSize::GradedSize(const SizeField& wanted, const GradedSize& other)
    : wanted_(wanted), slopes_(other.slopes_) {}

double GradedSize::sizeAt(const SurfacePoint& point) const {
  if (const auto* known = slopes_->corners.find(point)) return known->graded;
  return slopes_->graded(point, wanted_.sizeAt(point));
}

double GradedSize::ungradedAt(const SurfacePoint& point) const {
  const auto* known = slopes_->corners.find(point);
  return known ? known->wanted : wanted_.sizeAt(point);
}

}  // namespace af2::geometry
