#include "geometry/retry/refinement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "geometry/base/constants.h"
#include "geometry/retry/retry_limits.h"
#include "geometry/sizes/growing_size.h"

namespace af2::geometry {

namespace {

/// Places of which each requests a clearly smaller size than those before it do there. The last
/// ones are compared one by one, all others are in trees; like the digits of a number, trees of
/// equal size become one, so that no place is sorted more than a few times.
class ClearlySmaller {
 public:
  ClearlySmaller(double growth, double largest) : growth_(growth), largest_(largest) {}

  void add(const SizeSource& source) {
    if (isCovered(source)) return;
    places_.push_back(source);
    if (places_.size() - inTrees_ < kMaxUnsortedPlaces) return;
    std::size_t first = std::exchange(inTrees_, places_.size());
    while (!trees_.empty() && first - trees_.back().first == places_.size() - first) {
      first = trees_.back().first;
      trees_.pop_back();
    }
    const auto begin = places_.begin() + static_cast<std::ptrdiff_t>(first);
    trees_.push_back({first, GrowingSize({begin, places_.end()}, growth_, largest_)});
  }

  std::vector<SizeSource> take() { return std::move(places_); }

 private:
  struct Tree {
    std::size_t first;  ///< of its places
    GrowingSize sizes;
  };

  bool isCovered(const SizeSource& source) const {
    const double limit = kClearlySmaller * source.size;
    const auto covers = [&](const SizeSource& other) {
      const Point3 way = other.position - source.position;
      const double reach = kMoreThanRounding * (limit - other.size);
      if (growth_ * growth_ * dot(way, way) > reach * reach) return false;
      return other.size + growth_ * length(way) <= limit;
    };
    if (largest_ <= limit) return true;
    if (std::any_of(places_.begin() + static_cast<std::ptrdiff_t>(inTrees_), places_.end(), covers))
      return true;
    const double beyond = std::nextafter(limit, std::numeric_limits<double>::infinity());
    return std::ranges::any_of(
        trees_, [&](const Tree& tree) { return tree.sizes.at(source.position, beyond) <= limit; });
  }

  double growth_, largest_;
  std::vector<SizeSource> places_;
  std::size_t inTrees_ = 0;  ///< the first of these
  std::vector<Tree> trees_;
};

/// The places that request clearly smaller sizes than the others do there; the smallest first.
std::vector<SizeSource> thinned(std::vector<SizeSource> sources, double growth, double largest) {
  std::ranges::stable_sort(sources, {}, &SizeSource::size);
  ClearlySmaller kept(growth, largest);
  for (const SizeSource& source : sources) kept.add(source);
  return kept.take();
}

/// Sizes that grow from some places.
struct NearPlaces {
  std::shared_ptr<const GrowingSize> near;

  void operator()(std::span<const Point3> at, std::span<double> sizes) const {
    std::ranges::fill(sizes, std::numeric_limits<double>::infinity());
    lower(at, sizes);
  }
  void lower(std::span<const Point3> at, std::span<double> sizes) const { near->lower(at, sizes); }
};

}  // namespace

void Refinement::add(std::size_t face, const std::vector<SizeSource>& places) {
  std::vector<SizeSource>& added = places_[face].emplace_back();
  for (const SizeSource& place : places)
    added.push_back({place.position, std::max(place.size, kMinSizeShare * largest_)});
}

void Refinement::dropLast(std::size_t face) {
  const auto found = places_.find(face);
  if (found == places_.end()) return;
  found->second.pop_back();
  if (found->second.empty()) places_.erase(found);
}

void Refinement::dropAll(std::size_t face) {
  places_.erase(face);
  collapsed_.erase(face);
}

CollapsedEdges Refinement::collapsedEdges() const {
  CollapsedEdges all;
  for (const auto& [face, edges] : collapsed_) all.insert(edges.begin(), edges.end());
  return all;
}

bool Refinement::asksAlike(const Refinement& other, std::size_t face) const {
  const auto alike = [](const SizeSource& a, const SizeSource& b) {
    return a.position == b.position && a.size == b.size && a.radius == b.radius;
  };
  const auto alikeInRound = [&](const auto& a, const auto& b) {
    return std::ranges::equal(a, b, alike);
  };
  const auto own = places_.find(face), others = other.places_.find(face);
  if (has(face) != other.has(face)) return false;
  if (has(face) && !std::ranges::equal(own->second, others->second, alikeInRound)) return false;
  const auto points = collapsed_.find(face), otherPoints = other.collapsed_.find(face);
  if (points == collapsed_.end() || otherPoints == other.collapsed_.end())
    return points == collapsed_.end() && otherPoints == other.collapsed_.end();
  return points->second == otherPoints->second;
}

void Refinement::soften(std::size_t face, double factor) {
  const auto found = places_.find(face);
  if (found == places_.end()) return;
  for (std::vector<SizeSource>& places : found->second)
    for (SizeSource& place : places) place.size *= factor;
}

PositionSize refinedSizes(PositionSize asked, std::vector<SizeSource> places, double growth,
                          double largest) {
  if (places.empty()) return asked;
  const auto near = std::make_shared<const GrowingSize>(std::move(places), growth, largest);
  return PositionSize::smallerOf(std::move(asked), NearPlaces{near});
}

RequestedSizes Refinement::requested() const {
  std::vector<SizeSource> sources;
  for (const auto& [face, rounds] : places_)
    for (const std::vector<SizeSource>& places : rounds)
      sources.insert(sources.end(), places.begin(), places.end());
  RequestedSizes all{thinned(std::move(sources), growth_, largest_), {}};
  all.sizes = refinedSizes(asked_, all.places, growth_, largest_);
  return all;
}

}  // namespace af2::geometry
