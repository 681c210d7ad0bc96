#include "geometry/retry/retry_allowance.h"

#include <algorithm>
#include <limits>

namespace af2::geometry {

double mostEffort(const std::vector<FaceMesh>& meshes, double share) {
  constexpr double kShare = 3, kMost = 6'000'000, kAlways = 2'000'000;
  double candidates = 0;
  for (const FaceMesh& mesh : meshes) candidates += static_cast<double>(mesh.effort);
  return share * (std::min(kShare * candidates, kMost) + kAlways);
}

RetryAllowance::RetryAllowance(const std::vector<FaceMesh>& meshes,
                               const std::vector<std::size_t>& again, double left)
    : left_(std::max(left, 0.0)) {
  for (const std::size_t i : again) {
    if (!failed(meshes[i])) continue;
    faces_ += 1;
    effort_ += static_cast<double>(meshes[i].effort);
  }
}

std::size_t RetryAllowance::mostCandidates(const FaceMesh& before) const {
  constexpr double kAlways = 100'000, kAlwaysOfAll = 2'000'000, kTimes = 2;
  if (!failed(before)) return std::numeric_limits<std::size_t>::max();
  const auto effort = static_cast<double>(before.effort);
  const double share = std::max(1 / faces_, effort_ > 0 ? effort / effort_ : 0);
  return static_cast<std::size_t>(std::min(kAlways, kAlwaysOfAll / faces_) +
                                  std::min(kTimes * effort, share * left_));
}

}  // namespace af2::geometry
