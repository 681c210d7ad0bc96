#include "geometry/retry/spared_neighbors.h"

#include <algorithm>

namespace af2::geometry {

namespace {

bool isBad(const FaceMesh& mesh) { return failed(mesh) || mesh.diagnosis.hasBadAngle; }

}  // namespace

SparedNeighbors::SparedNeighbors(const std::vector<std::vector<int>>& edgesOfFaces,
                                 const std::vector<FaceMesh>& before)
    : edgesOfFaces_(edgesOfFaces), softened_(before.size(), 0) {
  for (const FaceMesh& mesh : before) wasBad_.push_back(isBad(mesh));
}

void SparedNeighbors::spare(const std::vector<FaceMesh>& next, Refinement& refinement,
                            std::vector<std::size_t>& changed,
                            const std::function<void(std::size_t)>& giveUp) {
  for (std::size_t i = 0; i < next.size(); ++i) {
    if (wasBad_[i] || !isBad(next[i])) continue;
    for (const std::size_t culprit : beside(i)) {
      if (!refinement.has(culprit) || !yields(culprit, refinement)) continue;
      giveUp(culprit);  // it asks for no more
      changed.push_back(culprit);
    }
  }
  std::ranges::sort(changed);
  changed.erase(std::ranges::unique(changed).begin(), changed.end());
}

bool SparedNeighbors::yields(std::size_t culprit, Refinement& refinement) {
  constexpr double kFactor = 2;
  constexpr int kMostTimes = 5;
  if (!wasBad_[culprit]) {
    refinement.dropAll(culprit);
    return true;
  }
  if (softened_[culprit] == kMostTimes) return false;
  ++softened_[culprit];
  refinement.soften(culprit, kFactor);
  return true;
}

std::vector<std::size_t> SparedNeighbors::beside(std::size_t i) const {
  const auto isEdgeOfIt = [&](int e) { return std::ranges::binary_search(edgesOfFaces_[i], e); };
  std::vector<std::size_t> found;
  for (std::size_t k = 0; k < edgesOfFaces_.size(); ++k)
    if (std::ranges::any_of(edgesOfFaces_[k], isEdgeOfIt)) found.push_back(k);
  return found;
}

}  // namespace af2::geometry
