#include "geometry/meshing/try_rounds.h"

#include <utility>

namespace af2::geometry {
namespace {

/// Faces may be similar without being congruent, and rounds wait for each other: after so many, all
/// that are left are meshed at once.
constexpr int kMostRounds = 4;

}  // namespace

TryRounds::TryRounds(std::vector<TryGroup> groups) : groups_(std::move(groups)) {}

std::vector<FaceTry> TryRounds::next() {
  const bool isLast = rounds_++ == kMostRounds;
  std::vector<FaceTry> tries;
  std::vector<TryGroup> left;
  for (TryGroup& group : groups_) {
    if (group.tries.empty()) continue;
    if (isLast) {
      tries.insert(tries.end(), group.tries.begin(), group.tries.end());
      continue;
    }
    tries.push_back(group.tries.front());
    group.tries.erase(group.tries.begin());
    left.push_back(std::move(group));
  }
  if (isLast) left.resize(tries.size());
  groups_ = std::move(left);
  return tries;
}

}  // namespace af2::geometry
