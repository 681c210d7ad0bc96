#include "geometry/sizes/position_size.h"

#include <algorithm>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/place_text.h"

namespace af2::geometry {

void PositionSize::at(std::span<const Point3> at, std::span<double> sizes) const {
  sizes_(at, sizes);
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (sizes[i] > 0) continue;
    throw InputError("the size function gives " + textOf(sizes[i]) + " at " + textOf(at[i]) +
                     "; it must be positive");
  }
}

double PositionSize::at(const Point3& position) const {
  double size = 0;
  at({&position, 1}, {&size, 1});
  return size;
}

void PositionSize::lower(std::span<const Point3> at, std::span<double> sizes) const {
  if (lower_) return lower_(at, sizes);
  if (at.size() == 1) {
    sizes[0] = std::min(sizes[0], this->at(at[0]));
    return;
  }
  std::vector<double> limits(at.size());
  this->at(at, limits);
  for (std::size_t i = 0; i < limits.size(); ++i) sizes[i] = std::min(sizes[i], limits[i]);
}

}  // namespace af2::geometry
