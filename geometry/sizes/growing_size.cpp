#include "geometry/sizes/growing_size.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "engine/base/parallel.h"
#include "geometry/base/constants.h"

namespace af2::geometry {
namespace {

/// Few enough to be looked at one by one.
constexpr std::size_t kLeaf = 8;

std::size_t middle(std::size_t first, std::size_t last) { return first + (last - first) / 2; }

/// How many nodes a tree over `count` sources has room for.
std::size_t treeSize(std::size_t count) {
  std::size_t size = 1;
  while (count > 2 * kLeaf) {
    count -= count / 2;
    size = 2 * size + 1;
  }
  return size;
}

/// What is farther away than this gives no smaller size. Larger than it is by more than all
/// rounding, so that the smallest size does not depend on what is looked at first.
double squaredReach(double distance) { return kMoreThanRounding * (distance * distance); }

/// The source that gave the last size in this thread: it is likely to give the next one as well, or
/// a bound near to it. Any other source is as right.
std::size_t& lastGiver() {
  thread_local std::size_t giver = 0;
  return giver;
}

}  // namespace

GrowingSize::GrowingSize(std::vector<SizeSource> sources, double growth, double largest,
                         int threads)
    : sources_(std::move(sources)), growth_(growth), perGrowth_(1 / growth), largest_(largest) {
  if (sources_.size() <= kLeaf) return;
  halves_.resize(treeSize(sources_.size()));
  build(0, 0, sources_.size(), threads);
}

GrowingSize::Box GrowingSize::boxOf(std::size_t first, std::size_t last) const {
  Box box{sources_[first].position, sources_[first].position, sources_[first].size, largest_};
  for (std::size_t i = first; i < last; ++i) {
    const SizeSource& s = sources_[i];
    const Point3& p = s.position;
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
    box.size = std::min(box.size, s.size);
    box.atCentres = std::min(box.atCentres, s.size - growth_ * s.radius);
  }
  return box;
}

GrowingSize::Box GrowingSize::build(std::size_t node, std::size_t first, std::size_t last,
                                    int threads) {
  const Box box = boxOf(first, last);
  if (last - first <= kLeaf) return box;
  const std::size_t half = middle(first, last);
  divide(box, first, half, last);
  Box a, b;
  const auto buildLeft = [&] { a = build(2 * node + 1, first, half, threads); };
  const auto buildRight = [&] { b = build(2 * node + 2, half, last, threads); };
  constexpr std::size_t kMany = 4096;  // take longer than to tell another thread of them
  if (last - first < kMany) {
    buildLeft();
    buildRight();
  } else {
    forEachInParallel(2, threads, [&](std::size_t i) { i == 0 ? buildLeft() : buildRight(); });
  }
  halves_[node] =
      Halves{Pair{a.low.x, b.low.x},   Pair{a.low.y, b.low.y},        Pair{a.low.z, b.low.z},
             Pair{a.high.x, b.high.x}, Pair{a.high.y, b.high.y},      Pair{a.high.z, b.high.z},
             Pair{a.size, b.size},     Pair{a.atCentres, b.atCentres}};
  return box;
}

/// In two halves across the longest side of their box.
void GrowingSize::divide(const Box& box, std::size_t first, std::size_t half, std::size_t last) {
  const Point3 extent = box.high - box.low;
  const auto along = [&](const Point3& p) {
    if (extent.x >= extent.y && extent.x >= extent.z) return std::tuple(p.x, p.y, p.z);
    if (extent.y >= extent.z) return std::tuple(p.y, p.z, p.x);
    return std::tuple(p.z, p.x, p.y);
  };
  const auto at = [&](std::size_t i) { return sources_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(first), at(half), at(last), [&](const SizeSource& a, const SizeSource& b) {
    return along(a.position) < along(b.position);
  });
}

/// From both boxes, and 0 inside.
Pair GrowingSize::squaredDistances(const Halves& h, const Point3& p) {
  const Pair x{p.x, p.x}, y{p.y, p.y}, z{p.z, p.z};
  const auto beyond = [](Pair value, Pair low, Pair high) {
    return larger(Pair{0, 0}, larger(low - value, value - high));
  };
  const Pair outX = beyond(x, h.lowX, h.highX), outY = beyond(y, h.lowY, h.highY),
             outZ = beyond(z, h.lowZ, h.highZ);
  return outX * outX + outY * outY + outZ * outZ;
}

/// Most sources are too far away, which the squares of the distances tell.
bool GrowingSize::lowerTo(std::size_t source, const Point3& position, double& least) const {
  const SizeSource& s = sources_[source];
  const double left = least - s.size;
  if (!(left > 0)) return false;
  const Point3 way = position - s.position;
  const double squared = dot(way, way);
  if (squared > squaredReach(left * perGrowth_ + s.radius)) return false;
  const double size = s.size + growth_ * std::max(0.0, std::sqrt(squared) - s.radius);
  if (!(size < least)) return false;
  least = size;
  return true;
}

/// Parts of the sources, the nearer half first.
void GrowingSize::look(std::size_t node, std::size_t first, std::size_t last,
                       const Point3& position, double& least) const {
  if (last - first <= kLeaf) {
    for (std::size_t i = first; i < last; ++i)
      if (lowerTo(i, position, least)) lastGiver() = i;
    return;
  }
  const Halves& halves = halves_[node];
  const Pair squared = squaredDistances(halves, position);
  const std::size_t half = middle(first, last), left = 2 * node + 1, right = left + 1;
  const auto mayGiveLess = [&](std::size_t i) {
    return halves.size[i] < least &&
           squared[i] <= squaredReach((least - halves.atCentres[i]) * perGrowth_);
  };
  const bool leftFirst = squared[0] <= squared[1];
  if (leftFirst && mayGiveLess(0)) look(left, first, half, position, least);
  if (mayGiveLess(1)) look(right, half, last, position, least);
  if (!leftFirst && mayGiveLess(0)) look(left, first, half, position, least);
}

double GrowingSize::at(const Point3& position, double most) const {
  double least = std::min(most, largest_);
  if (const std::size_t giver = lastGiver(); giver < sources_.size())
    lowerTo(giver, position, least);
  look(0, 0, sources_.size(), position, least);
  return least;
}

/// Sizes change no faster than they grow: what is known at one place tells how small they may be at
/// the next ones. The larger the size up to which one is known, the more places it tells of.
void GrowingSize::lower(std::span<const Point3> at, std::span<double> sizes) const {
  constexpr double kSlack = 1.25;
  if (at.size() == 1) {
    sizes[0] = this->at(at[0], sizes[0]);
    return;
  }
  Point3 last;
  double known = -std::numeric_limits<double>::infinity();  // at `last`, or less
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (kMoreThanRounding * sizes[i] <= known - growth_ * distance(last, at[i])) continue;
    last = at[i];
    known = this->at(last, kSlack * sizes[i]);
    sizes[i] = std::min(sizes[i], known);
  }
}

/// A source is covered if the others give at most its size everywhere in its ball: then they do so
/// wherever it applies.
std::vector<SizeSource> uncovered(const std::vector<SizeSource>& sources, double growth,
                                  int threads) {
  constexpr double kClearly = 1 - 1e-9;  // more than rounding, and nothing is covered by itself
  constexpr std::size_t kAtOnce = 256;
  const GrowingSize all(sources, growth, std::numeric_limits<double>::infinity(), threads);
  std::vector<std::uint8_t> isCovered(sources.size());
  forEachInRanges(sources.size(), kAtOnce, threads, [&](std::size_t i) {
    const SizeSource& s = sources[i];
    const double limit = kClearly * s.size - growth * s.radius;
    isCovered[i] = all.at(s.position, limit) < limit;
  });
  std::vector<SizeSource> kept;
  for (std::size_t i = 0; i < sources.size(); ++i)
    if (!isCovered[i]) kept.push_back(sources[i]);
  return kept;
}

}  // namespace af2::geometry
