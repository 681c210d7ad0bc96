#include "geometry/growing_size.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace af2::geometry {
namespace {

/// Few enough to be looked at one by one.
constexpr std::size_t kLeaf = 4;

std::size_t middle(std::size_t first, std::size_t last) { return first + (last - first) / 2; }

/// How many boxes a tree over `count` sources has room for.
std::size_t treeSize(std::size_t count) {
  std::size_t size = 1;
  while (count > kLeaf) {
    count -= count / 2;
    size = 2 * size + 1;
  }
  return size;
}

double beyond(double value, double low, double high) {
  return value < low ? low - value : std::max(0.0, value - high);
}

}  // namespace

GrowingSize::GrowingSize(std::vector<SizeSource> sources, double growth, double largest)
    : sources_(std::move(sources)), growth_(growth), largest_(largest) {
  if (sources_.empty()) return;
  boxes_.resize(treeSize(sources_.size()));
  build(0, 0, sources_.size());
}

void GrowingSize::build(std::size_t node, std::size_t first, std::size_t last) {
  Box box{sources_[first].position, sources_[first].position, sources_[first].size, largest_};
  for (std::size_t i = first; i < last; ++i) {
    const SizeSource& s = sources_[i];
    const Point3& p = s.position;
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
    box.size = std::min(box.size, s.size);
    box.atCentres = std::min(box.atCentres, s.size - growth_ * s.radius);
  }
  boxes_[node] = box;
  if (last - first <= kLeaf) return;
  const Point3 extent = box.high - box.low;
  const auto along = [&](const Point3& p) {
    if (extent.x >= extent.y && extent.x >= extent.z) return std::tuple(p.x, p.y, p.z);
    if (extent.y >= extent.z) return std::tuple(p.y, p.z, p.x);
    return std::tuple(p.z, p.x, p.y);
  };
  const auto at = [&](std::size_t i) { return sources_.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::size_t half = middle(first, last);
  std::nth_element(at(first), at(half), at(last), [&](const SizeSource& a, const SizeSource& b) {
    return along(a.position) < along(b.position);
  });
  build(2 * node + 1, first, half);
  build(2 * node + 2, half, last);
}

double GrowingSize::leastIn(const Box& box, const Point3& p) const {
  const Point3 outside{beyond(p.x, box.low.x, box.high.x), beyond(p.y, box.low.y, box.high.y),
                       beyond(p.z, box.low.z, box.high.z)};
  return std::max(box.size, box.atCentres + growth_ * length(outside));
}

void GrowingSize::look(std::size_t node, std::size_t first, std::size_t last,
                       const Point3& position, double& least) const {
  if (last - first <= kLeaf) {
    for (std::size_t i = first; i < last; ++i) {
      const SizeSource& s = sources_[i];
      const double outside = std::max(0.0, distance(s.position, position) - s.radius);
      least = std::min(least, s.size + growth_ * outside);
    }
    return;
  }
  const std::size_t half = middle(first, last), left = 2 * node + 1, right = left + 1;
  const double inLeft = leastIn(boxes_[left], position), inRight = leastIn(boxes_[right], position);
  const bool leftFirst = inLeft <= inRight;
  if (leftFirst && inLeft < least) look(left, first, half, position, least);
  if (inRight < least) look(right, half, last, position, least);
  if (!leftFirst && inLeft < least) look(left, first, half, position, least);
}

double GrowingSize::at(const Point3& position) const {
  double least = largest_;
  if (!sources_.empty() && leastIn(boxes_[0], position) < least)
    look(0, 0, sources_.size(), position, least);
  return least;
}

}  // namespace af2::geometry
