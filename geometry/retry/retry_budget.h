// The budget for retrying faces that failed or came out poor, in candidates of the front.
// Not installed.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/mesh/face_mesh.h"

namespace af2::geometry {

/// The budget of all remedies together. It depends only on the meshes, never on the clock.
class RetryBudget {
 public:
  explicit RetryBudget(double total) : total_(total) {}

  double left() const { return total_ - spent_; }
  bool isOverdrawn() const { return spent_ > total_; }
  /// Charges the cost of one face that was meshed again.
  void charge(const FaceMesh& mesh);
  /// Takes the total of another budget.
  void allow(const RetryBudget& other) { total_ = other.total_; }
  /// The same budget, with nothing spent.
  RetryBudget anew() const { return RetryBudget(total_); }

 private:
  double total_, spent_ = 0;
};

/// The budget: a multiple of the cost of the mesh, but no more than about ten seconds.
///
/// share  factor for this budget
RetryBudget budgetFor(const std::vector<FaceMesh>& meshes, double share);

/// The candidates that failed faces may use when they are meshed again, all at the same time.
class RetryAllowance {
 public:
  /// before  the former meshes of all faces that are meshed again; only those that failed count
  /// left    candidates left for all of them
  RetryAllowance(const std::vector<const FaceMesh*>& before, double left);

  /// The limit for a face. A face that failed may use more than before, because shorter edges cost
  /// more, but no more than its share of the remaining candidates, by the number of faces or by its
  /// former cost. Other faces are not limited.
  std::size_t maxCandidates(const FaceMesh& before) const;

 private:
  double left_;
  double faces_ = 0;       ///< the number of failed faces
  double searchCost_ = 0;  ///< their former cost
};

}  // namespace af2::geometry
