#include "geometry/sizes/chord.h"

#include <cmath>
#include <limits>

#include "engine/base/error.h"

namespace af2::geometry {
namespace {

void check(const ChordBound& bound, const std::string& where) {
  if (!(bound.value > 0) || !std::isfinite(bound.value))
    throw InputError("the bound on the distance from the model" + where + " must be positive");
}

}  // namespace

void checkChords(const ChordBounds& chords) {
  if (chords.everywhere != ChordBound{}) check(chords.everywhere, "");
  for (const auto& [face, bound] : chords.faces) check(bound, " for face " + std::to_string(face));
  for (const auto& [name, bound] : chords.parts) check(bound, " for parts named '" + name + "'");
}

double longestChord(double radius, double height) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  if (!(height < radius) || !std::isfinite(radius)) return kInfinite;
  return 2 * std::sqrt(height * (2 * radius - height));
}

}  // namespace af2::geometry
