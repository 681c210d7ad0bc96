#include "geometry/sizes/position_size.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "engine/base/error.h"
#include "engine/base/place_text.h"

namespace af2::geometry {

struct PositionSize::Made {
  Fill sizes;
  Fill lower;                          ///< may be empty
  PositionSize asked = {}, less = {};  ///< of smallerOf
};

void PositionSize::make(Fill sizes, Fill lower) {
  made_ = std::make_shared<const Made>(Made{std::move(sizes), std::move(lower)});
}

PositionSize PositionSize::smallerOf(PositionSize asked, PositionSize less) {
  if (!asked) return less;
  Made made;
  made.lower = [asked, less](std::span<const Point3> at, std::span<double> sizes) {
    less.lower(at, sizes);
    asked.lower(at, sizes);
  };
  made.sizes = [lower = made.lower](std::span<const Point3> at, std::span<double> sizes) {
    std::ranges::fill(sizes, std::numeric_limits<double>::infinity());
    lower(at, sizes);
  };
  made.asked = std::move(asked);
  made.less = std::move(less);
  PositionSize both;
  both.made_ = std::make_shared<const Made>(std::move(made));
  return both;
}

const PositionSize& PositionSize::below(const PositionSize& asked) const {
  return made_ && made_->less && made_->asked.isSameAs(asked) ? made_->less : *this;
}

void PositionSize::at(std::span<const Point3> at, std::span<double> sizes) const {
  made_->sizes(at, sizes);
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
  if (made_->lower) return made_->lower(at, sizes);
  if (at.size() == 1) {
    sizes[0] = std::min(sizes[0], this->at(at[0]));
    return;
  }
  std::vector<double> limits(at.size());
  this->at(at, limits);
  for (std::size_t i = 0; i < limits.size(); ++i) sizes[i] = std::min(sizes[i], limits[i]);
}

}  // namespace af2::geometry
