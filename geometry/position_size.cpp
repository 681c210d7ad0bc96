#include "geometry/position_size.h"

#include <string>

#include "engine/error.h"

namespace af2::geometry {

void PositionSize::at(std::span<const Point3> at, std::span<double> sizes) const {
  sizes_(at, sizes);
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (sizes[i] > 0) continue;
    throw InputError("the size function gives " + std::to_string(sizes[i]) + " at (" +
                     std::to_string(at[i].x) + ", " + std::to_string(at[i].y) + ", " +
                     std::to_string(at[i].z) + "); it must be positive");
  }
}

double PositionSize::at(const Point3& position) const {
  double size = 0;
  at({&position, 1}, {&size, 1});
  return size;
}

}  // namespace af2::geometry
