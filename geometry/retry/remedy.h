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

/// What is known of one face over all rounds.
struct FaceRecord {
  bool wasBad = false;        ///< before any remedy: failed, or had an element hardly of use
  bool askedShorter = false;  ///< shorter edges were tried
  bool isGivenUp = false;     ///< nothing more is asked for its sake
  int failures = 0;           ///< tries that brought nothing
  int softenings = 0;         ///< of what it asked for
  FaceHistory remedies;       ///< that are under way
  /// Short edges to be collapsed, one choice after the other, the last first.
  std::vector<CollapsedEdges> shortEdges;
};

/// What remedies look at and change.
struct Retrial {
  const RetriedModel& model;
  const RetryOptions& options;
  Refinement requests;  ///< what is asked of the edges for the next round
  std::vector<FaceRecord> faces;
  RetryBudget budget;
  bool hasBudgetLeft = true;  ///< at the beginning of the round
  /// In ascending order: faces that are meshed again because something was taken back.
  std::vector<std::size_t> withdrawn = {};
  /// Meshes that others have taken the place of, to be put back.
  std::map<std::size_t, FaceMesh> replaced = {};
};

enum class RemedyTime {
  /// Asks for other edges. Of all such remedies, the first that applies to a face is tried; it is
  /// undone if the face gains nothing from the round.
  BeforeRound,
  /// Looks at what came of a round, and takes back what did harm.
  AfterRound,
  /// Asks for one more round after the best state was found, which is kept if it is better still.
  LastRound,
  /// At last: meshes one face after the other within the edges there are. It is undone where
  /// elements then cross others.
  InPlace,
};

struct FaceRemedy {
  const char* name;  ///< as the report of a face has it
  RemedyTime time;
  /// Whether it may be tried on a face.
  bool (*applies)(const Retrial& retrial, const FaceMeshes& state, std::size_t face);
  /// At how many places it is tried, 0 for the face as a whole; nothing: it has no use. Only
  /// remedies in place may change the state.
  std::optional<std::size_t> (*propose)(Retrial& retrial, FaceMeshes& state, std::size_t face);
  /// Takes back what it has proposed and was of no use; null: there is nothing to take back.
  ///
  /// next  what came of it
  void (*undo)(Retrial& retrial, FaceMeshes& state, const FaceMeshes& next,
               std::size_t face) = nullptr;
  /// Finds what it will need, before any remedy is tried.
  void (*begin)(Retrial& retrial, const FaceMeshes& state) = nullptr;
  /// Whether the report names it; else the mesh of the face tells by itself.
  bool isReported = true;
};

/// Changes joined meshes as they are. It is tried on a copy each time that meshes were joined, and
/// kept where the checks find less.
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
