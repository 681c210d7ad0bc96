#include "geometry/domain/face_memory.h"

#include <algorithm>
#include <utility>

namespace af2::geometry {

void FaceMemory::Key::add(const std::vector<BoundaryCorner>& corners) {
  numbers.push_back(static_cast<double>(corners.size()));
  for (const auto& [vertex, point] : corners) {
    numbers.push_back(vertex.value);
    for (const Point3& p : {point.position, point.normal})
      numbers.insert(numbers.end(), {p.x, p.y, p.z});
    numbers.insert(numbers.end(), {point.u, point.v});
  }
}

std::shared_ptr<const FaceMemory::Filled> FaceMemory::find(const Key& key) const {
  const std::lock_guard lock(mutex_);
  const auto ofSurface = known_.find(key.surface);
  if (ofSurface == known_.end()) return nullptr;
  const auto known = std::ranges::find(ofSurface->second, key.numbers, &Known::first);
  return known == ofSurface->second.end() ? nullptr : known->second;
}

void FaceMemory::keep(const Key& key, std::shared_ptr<const Filled> filled) {
  constexpr std::size_t kMostElements = 3'000'000;
  const std::lock_guard lock(mutex_);
  if (elements_ + filled->mesh.elements.size() > kMostElements) return;
  elements_ += filled->mesh.elements.size();
  known_[key.surface].emplace_back(key.numbers, std::move(filled));
}

}  // namespace af2::geometry
