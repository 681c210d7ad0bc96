// Tries at faces, in rounds: of each group of faces that may be congruent, one is meshed, and those
// that are congruent to it take over its mesh. Not installed.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/meshing/congruent_faces.h"

namespace af2::geometry {

class TryRounds {
 public:
  explicit TryRounds(std::vector<TryGroup> groups);

  /// Those to be meshed next; none: all are done.
  std::vector<FaceTry> next();
  /// The others of the group of the k-th of these. Those that take over its mesh are to be removed;
  /// the first of the others is meshed in the next round.
  std::vector<FaceTry>& others(std::size_t k) { return groups_[k].tries; }

 private:
  std::vector<TryGroup> groups_;
  int rounds_ = 0;
};

}  // namespace af2::geometry
