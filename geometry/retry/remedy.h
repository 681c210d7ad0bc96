// One remedy for faces that failed, came out poor or cross each other: a row of the tables in
// remedies.cpp.
// Not installed.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "geometry/retry/refinement.h"
#include "geometry/retry/retries.h"
#include "geometry/retry/retry_budget.h"

namespace af2::geometry {

/// The data on one face over all rounds.
struct FaceRecord {
  bool wasBad = false;  ///< before any remedy: failed, or had an element that is hardly usable
  bool askedShorter = false;  ///< shorter edges were tried
  bool hasFault = false;      ///< that no edges can mend; known of faces that failed at first
  bool isGivenUp = false;     ///< no more requests are made for it
  int failures = 0;           ///< tries without benefit
  int softenings = 0;         ///< of its requests
  FaceHistory remedies;       ///< in progress
  /// Alternatives of short edges to collapse, tried from last to first.
  std::vector<CollapsedEdges> shortEdges;
};

/// The state that remedies read and change.
struct Retrial {
  const RetriedModel& model;
  const RetryOptions& options;
  Refinement requests;  ///< requests for the edges in the next round
  std::vector<FaceRecord> faces;
  RetryBudget budget;
  bool hasBudgetLeft = true;  ///< at the beginning of the round
  /// In ascending order: faces that are meshed again because requests were withdrawn.
  std::vector<std::size_t> withdrawn = {};
  /// Meshes that were replaced, kept so that they can be restored.
  std::map<std::size_t, FaceMesh> replaced = {};
};

enum class RemedyTime {
  /// Requests other edges. Of all such remedies, the first that applies to a face is tried; it is
  /// undone if the face does not improve in the round.
  BeforeRound,
  /// Examines the result of a round, and withdraws harmful requests.
  AfterRound,
  /// Requests one more round after the best state was found; its result is kept if it is better.
  LastRound,
  /// The last step: meshes one face after the other within the existing edges. It is undone where
  /// elements then cross others.
  InPlace,
};

struct FaceRemedy {
  const char* name;  ///< as in the report of a face
  RemedyTime time;
  /// Whether it may be tried on a face.
  bool (*applies)(const Retrial& retrial, const FaceMeshes& state, std::size_t face);
  /// Returns the number of places at which it is tried, 0 for the face as a whole, or nothing if it
  /// is of no use. Only remedies in place may change the state.
  std::optional<std::size_t> (*propose)(Retrial& retrial, FaceMeshes& state, std::size_t face);
  /// Withdraws a proposal that did not help; null: there is nothing to withdraw.
  ///
  /// next  the state that resulted from it
  void (*undo)(Retrial& retrial, FaceMeshes& state, const FaceMeshes& next,
               std::size_t face) = nullptr;
  /// Collects the data that it needs on a face, from its first mesh.
  void (*begin)(Retrial& retrial, const FaceMeshes& state, std::size_t face) = nullptr;
  /// Whether the report names it; if not, the mesh of the face shows it.
  bool isReported = true;
};

/// Changes the meshes of faces directly. It is tried on a copy each time that meshes are joined,
/// and kept if the checks then have fewer findings.
struct MeshRemedy {
  const char* name;
  bool (*applies)(const MeshFaults& faults);
  /// Returns how many changes it made.
  std::size_t (*propose)(const DividedEdges& divided, std::vector<FaceMesh>& meshes);
  bool (*isBetter)(const MeshFaults& before, const MeshFaults& after);
};

/// In the order in which they are tried.
std::span<const FaceRemedy> faceRemedies();
std::span<const MeshRemedy> meshRemedies();

}  // namespace af2::geometry
