// What it may cost to try again at faces that failed or came out poor, in candidates of the front.
// Not installed.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/mesh/face_mesh.h"

namespace af2::geometry {

/// Of all remedies together. Depends on the meshes alone, never on the clock.
class RetryBudget {
 public:
  explicit RetryBudget(double total) : total_(total) {}

  double left() const { return total_ - spent_; }
  bool isOverdrawn() const { return spent_ > total_; }
  /// For one face that was meshed again.
  void charge(const FaceMesh& mesh);
  /// The same budget, of which nothing is spent.
  RetryBudget anew() const { return RetryBudget(total_); }

 private:
  double total_, spent_ = 0;
};

/// Tries may cost some times as much as the mesh, but no more than about ten seconds.
///
/// share  of that which may be taken
RetryBudget budgetFor(const std::vector<FaceMesh>& meshes, double share);

/// What faces that failed may take when they are meshed once more, all at the same time.
class RetryAllowance {
 public:
  /// again  the faces that are meshed once more; those of them count that failed
  /// left   for all of them
  RetryAllowance(const std::vector<FaceMesh>& meshes, const std::vector<std::size_t>& again,
                 double left);

  /// A face that failed may fail again, and shorter edges are dearer; but no more than its share of
  /// what is left, be it by number or by what it took before. Other faces take what they need.
  std::size_t maxCandidates(const FaceMesh& before) const;

 private:
  double left_;
  double faces_ = 0;       ///< so many there are
  double searchCost_ = 0;  ///< that they took before
};

}  // namespace af2::geometry
