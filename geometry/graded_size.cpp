#include "geometry/graded_size.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace af2::geometry {

namespace {

/// Segments come out up to a third shorter than wanted, to divide an edge evenly; that needs no
/// grading.
constexpr double kShort = 0.6;

/// A source may be left out if the others around it want no more than this times its size there.
constexpr double kThinning = 1.3;

double largestWanted(const FrontInput& boundary, const SizeField& wanted) {
  double largest = 0;
  for (const auto& loop : boundary.loops)
    for (const BoundaryCorner& corner : loop)
      largest = std::max(largest, wanted.sizeAt(corner.point));
  return largest;
}

}  // namespace

GrowingSize::GrowingSize(std::vector<SizeSource> sources, double growth, double largest)
    : sources_(std::move(sources)), growth_(growth), largest_(largest) {
  if (sources_.empty()) return;
  double smallest = largest_;
  for (const SizeSource& s : sources_) smallest = std::min(smallest, s.size);
  cellSize_ = std::max(largest_ - smallest, 1e-3 * largest_) / growth_;  // how far a source reaches
  thin();
  sortIntoCells();
}

std::int64_t GrowingSize::cellOf(double coordinate) const {
  return static_cast<std::int64_t>(std::floor(coordinate / cellSize_));
}

/// Keeps every second source or so of an evenly divided edge: the smallest first, in order.
void GrowingSize::thin() {
  std::stable_sort(sources_.begin(), sources_.end(),
                   [](const SizeSource& a, const SizeSource& b) { return a.size < b.size; });
  std::vector<SizeSource> kept;
  for (const SizeSource& s : sources_) {
    // Neighbours along a loop were added shortly before, so a look at the last ones is enough.
    const std::size_t from = kept.size() > 16 ? kept.size() - 16 : 0;
    bool covered = false;
    for (std::size_t i = from; i < kept.size() && !covered; ++i)
      covered =
          kept[i].size + growth_ * distance(kept[i].position, s.position) <= kThinning * s.size;
    if (!covered) kept.push_back(s);
  }
  sources_ = std::move(kept);
}

void GrowingSize::sortIntoCells() {
  const auto key = [&](const SizeSource& s) {
    return std::tuple(cellOf(s.position.x), cellOf(s.position.y), cellOf(s.position.z));
  };
  std::stable_sort(sources_.begin(), sources_.end(),
                   [&](const SizeSource& a, const SizeSource& b) { return key(a) < key(b); });
  for (std::uint32_t i = 0; i < sources_.size(); ++i) {
    const auto [x, y, z] = key(sources_[i]);
    if (cells_.empty() ||
        std::tuple(cells_.back().x, cells_.back().y, cells_.back().z) != key(sources_[i]))
      cells_.push_back({x, y, z, i, i});
    cells_.back().last = i + 1;
  }
}

double GrowingSize::at(const Point3& position) const {
  double size = largest_;
  const std::int64_t x = cellOf(position.x), y = cellOf(position.y), z = cellOf(position.z);
  for (std::int64_t i = x - 1; i <= x + 1; ++i) {
    for (std::int64_t j = y - 1; j <= y + 1; ++j) {
      auto cell = std::lower_bound(cells_.begin(), cells_.end(), Cell{i, j, z - 1, 0, 0});
      for (; cell != cells_.end() && cell->x == i && cell->y == j && cell->z <= z + 1; ++cell)
        for (std::uint32_t k = cell->first; k < cell->last; ++k)
          size =
              std::min(size, sources_[k].size + growth_ * distance(sources_[k].position, position));
    }
  }
  return size;
}

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
      growing_(shortSegments(boundary, wanted), growth, largestWanted(boundary, wanted)) {}

double GradedSize::sizeAt(const SurfacePoint& point) const {
  const double wanted = wanted_.sizeAt(point);
  return growing_.isEmpty() ? wanted : std::min(wanted, growing_.at(point.position));
}

}  // namespace af2::geometry
