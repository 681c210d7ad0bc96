#include "geometry/retry/retry_budget.h"

#include <algorithm>
#include <limits>

#include "geometry/retry/retry_limits.h"

namespace af2::geometry {

void RetryBudget::charge(const FaceMesh& mesh) {
  spent_ += static_cast<double>(mesh.searchCost) + kCostOfFace;
}

RetryBudget budgetFor(const std::vector<FaceMesh>& meshes, double share) {
  double candidates = 0;
  for (const FaceMesh& mesh : meshes) candidates += static_cast<double>(mesh.searchCost);
  return RetryBudget(share * (std::min(kBudgetShare * candidates, kMaxBudget) + kMinBudget));
}

RetryAllowance::RetryAllowance(const std::vector<const FaceMesh*>& before, double left)
    : left_(std::max(left, 0.0)) {
  for (const FaceMesh* mesh : before) {
    if (!failed(*mesh)) continue;
    faces_ += 1;
    searchCost_ += static_cast<double>(mesh->searchCost);
  }
}

std::size_t RetryAllowance::maxCandidates(const FaceMesh& before) const {
  if (!failed(before)) return std::numeric_limits<std::size_t>::max();
  const auto searchCost = static_cast<double>(before.searchCost);
  const double share = std::max(1 / faces_, searchCost_ > 0 ? searchCost / searchCost_ : 0);
  return static_cast<std::size_t>(std::min(kMinBudgetOfFailed, kMinBudgetOfAllFailed / faces_) +
                                  std::min(kBudgetOfFailed * searchCost, share * left_));
}

}  // namespace af2::geometry
