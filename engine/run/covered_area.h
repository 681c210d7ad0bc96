// How much area the elements of a growing mesh have. Not installed.
#pragma once

#include <cmath>
#include <cstddef>

#include "engine/mesh/element_area.h"

namespace af2 {

/// Each element is measured once, where it was made.
class CoveredArea {
 public:
  /// unit  of the results; 0: nothing is measured
  explicit CoveredArea(double unit) : unit_(unit) {}

  /// In whole units, rounded down.
  std::size_t of(const Mesh& mesh) {
    if (!(unit_ > 0)) return 0;
    for (; measured_ < mesh.elements.size(); ++measured_)
      area_ += areaOf(mesh, mesh.elements[measured_]);
    constexpr double kMost = 1e18;
    return static_cast<std::size_t>(std::fmin(area_ / unit_, kMost));
  }

 private:
  double unit_, area_ = 0;
  std::size_t measured_ = 0;
};

}  // namespace af2
