// One way to fill a face: a row of the table in fill_ways.cpp.
// Not installed.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/fill/fill_face.h"

namespace af2::geometry {

/// What has come of the ways that were tried so far.
struct FillState {
  const FaceTask& task;
  std::vector<const ChartTraits*> charts = {};  ///< of the face, in the order of trying
  std::vector<FaceAttempt> failed = {};         ///< in the order in which they were tried
  FaceHistory history = {};                     ///< of these
  std::size_t searchCost = 0;                   ///< of these
  std::optional<FaceAttempt> best = {};         ///< complete and sound, or cancelled

  /// An attempt came to nothing.
  void fail(std::string name, FaceAttempt attempt);
};

/// Ways are tried in the order of the table, where they apply.
struct FillWay {
  const char* name;
  /// Whether the way is tried, given what came of those before it.
  bool (*applies)(const FillState& state);
  /// Throws GeometryError if the surface gives no charts. A fault of kind NotFilled says that there
  /// was nothing to begin with, or that the state knows what failed; it is not reported. May take
  /// over what has failed before.
  FaceAttempt (*fill)(FillState& state);
  /// Whether a sound mesh is taken; null: always.
  bool (*isBetter)(const FillState& state, const FaceAttempt& attempt) = nullptr;
  /// If the way fails, no other can help.
  bool isCondition = false;
  /// It is a way of those tries alone at which all else has failed.
  bool ignoresNormals = false;
};

/// All ways, in the order in which they are tried.
std::span<const FillWay> fillWays();

/// Whether all ways so far have failed.
inline bool isUnfilled(const FillState& state) { return !state.best.has_value(); }

}  // namespace af2::geometry
