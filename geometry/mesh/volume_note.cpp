#include "geometry/mesh/volume_note.h"

#include <cmath>

#include "engine/base/place_text.h"

namespace af2::geometry {

std::string volumeNote(double enclosed, double wanted, const std::string& of) {
  constexpr double kFair = 0.02;
  if (wanted == 0) return "";
  const double more = enclosed / wanted - 1;
  if (!(std::abs(more) > kFair)) return "";
  return "the mesh encloses " + af2::textOf(100 * std::abs(more), 2) +
         (more < 0 ? " % less" : " % more") + " volume than " + of +
         "; a smaller size, or elements by curvature, follow the surface more closely";
}

}  // namespace af2::geometry
