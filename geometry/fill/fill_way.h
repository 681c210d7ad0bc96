// One way to fill a face: a row of the table in fill_ways.cpp.
// Not installed.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/fill/fill_face.h"

namespace af2::geometry {

/// The results of the ways that were tried so far.
struct FillState {
  const FaceTask& task;
  std::vector<const ChartTraits*> charts = {};  ///< of the face, in the order of trying
  std::vector<FaceAttempt> failed = {};         ///< in the order in which they were tried
  FaceHistory history = {};                     ///< of these
  std::size_t searchCost = 0;                   ///< of these
  std::optional<FaceAttempt> best = {};         ///< complete and sound, or cancelled

  /// Records an attempt that failed.
  void fail(std::string name, FaceAttempt attempt);
};

/// Ways that apply are tried in the order of the table.
struct FillWay {
  const char* name;
  /// Whether the way is tried, given the results of those before it.
  bool (*applies)(const FillState& state);
  /// Throws GeometryError if the surface gives no charts. A fault of kind NotFilled means that
  /// there was nothing to start from, or that the state already has the failure; it is not
  /// reported. May take over earlier failed attempts from the state.
  FaceAttempt (*fill)(FillState& state);
  /// Whether a sound mesh is taken; null: always.
  bool (*isBetter)(const FillState& state, const FaceAttempt& attempt) = nullptr;
  /// If the way fails, no other can help.
  bool isCondition = false;
  /// Whether the way is used only in tries that ignore normals, after everything else has failed.
  bool ignoresNormals = false;
  /// It makes elements without rules, or such as rules would not: it is left out where only rules
  /// may make elements.
  bool needsNoRule = false;
};

/// All ways, in the order in which they are tried.
std::span<const FillWay> fillWays();

/// Whether all ways so far have failed.
inline bool isUnfilled(const FillState& state) { return !state.best.has_value(); }

}  // namespace af2::geometry
