// Bounds on the distance between a mesh and its model.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/export.h"

namespace af2::geometry {

/// A length, in model units, or a share of the wanted size; 0: no bound.
struct ChordBound {
  double value = 0;
  bool isShareOfSize = false;

  bool isGiven() const { return value > 0; }
  bool operator==(const ChordBound&) const = default;
};

struct ChordBounds {
  ChordBound everywhere;
  std::map<int, ChordBound> faces;  ///< by face id; instead of `everywhere`
  /// By name of a face or group, as Sizes::partSizes. `faces` take precedence.
  std::vector<std::pair<std::string, ChordBound>> parts;

  /// By face id: the share of its bound for which sizes are chosen, because lengths of edges
  /// scatter around sizes; else 1. The mesher lowers it where that is not enough.
  std::map<int, double> aims;

  double aimOf(int face) const {
    const auto found = aims.find(face);
    return found == aims.end() ? 1 : found->second;
  }
  bool areGiven() const { return everywhere.isGiven() || !faces.empty() || !parts.empty(); }
};

/// Throws InputError for a bound that is not a positive number.
AF2_EXPORT void checkChords(const ChordBounds& chords);

/// The length of a chord whose middle is `height` away from a circle. Infinite if no chord of the
/// circle is farther away than that.
AF2_EXPORT double longestChord(double radius, double height);

}  // namespace af2::geometry
