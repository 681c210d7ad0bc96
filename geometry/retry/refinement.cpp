#include "geometry/retry/refinement.h"

#include <algorithm>
#include <memory>
#include <span>

#include "geometry/retry/retry_limits.h"
#include "geometry/sizes/growing_size.h"

namespace af2::geometry {

namespace {

/// The places that request clearly smaller sizes than the others do there; the smallest first.
std::vector<SizeSource> thinned(std::vector<SizeSource> sources, double growth, double largest) {
  std::ranges::stable_sort(sources, {}, &SizeSource::size);
  std::vector<SizeSource> kept;
  GrowingSize tree({}, growth, largest);
  std::size_t inTree = 0;
  for (const SizeSource& source : sources) {
    const auto covers = [&](const SizeSource& other) {
      return other.size + growth * distance(other.position, source.position) <=
             kClearlySmaller * source.size;
    };
    if (tree.at(source.position) <= kClearlySmaller * source.size) continue;
    if (std::any_of(kept.begin() + static_cast<std::ptrdiff_t>(inTree), kept.end(), covers))
      continue;
    kept.push_back(source);
    if (kept.size() - inTree < kMaxUnsortedPlaces) continue;
    tree = GrowingSize(kept, growth, largest);
    inTree = kept.size();
  }
  return kept;
}

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

void Refinement::soften(std::size_t face, double factor) {
  const auto found = places_.find(face);
  if (found == places_.end()) return;
  for (std::vector<SizeSource>& places : found->second)
    for (SizeSource& place : places) place.size *= factor;
}

PositionSize Refinement::sizes() const {
  std::vector<SizeSource> sources;
  for (const auto& [face, rounds] : places_)
    for (const std::vector<SizeSource>& places : rounds)
      sources.insert(sources.end(), places.begin(), places.end());
  if (sources.empty()) return asked_;
  const auto near = std::make_shared<const GrowingSize>(
      thinned(std::move(sources), growth_, largest_), growth_, largest_);
  return [near, asked = asked_](std::span<const Point3> at, std::span<double> sizes) {
    for (std::size_t i = 0; i < at.size(); ++i) sizes[i] = near->at(at[i]);
    if (!asked) return;
    std::vector<double> limits(at.size());
    asked.at(at, limits);
    for (std::size_t i = 0; i < at.size(); ++i) sizes[i] = std::min(sizes[i], limits[i]);
  };
}

}  // namespace af2::geometry
