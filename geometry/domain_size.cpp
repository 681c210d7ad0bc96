#include "geometry/domain_size.h"

#include <algorithm>
#include <numbers>

namespace af2::geometry {

DomainSize::DomainSize(const DomainMeshingOptions& options) : options_(options) {
  if (!options.sources.isEmpty()) sources_ = sizeFrom(options.sources, options.growth);
}

double DomainSize::at(const Point3& position) const {
  double size = options_.size;
  if (options_.function) size = std::min(size, options_.function.at(position));
  if (sources_) size = std::min(size, sources_.at(position));
  return bounded(size);
}

double DomainSize::limitedByTurn(double size, double radius, double gentleLeast) const {
  constexpr double kGentleTurn = std::numbers::pi / 4;
  const bool isAsked = options_.elementsPerTurn > 0;
  const double turn = isAsked ? 2 * std::numbers::pi / options_.elementsPerTurn : kGentleTurn;
  const double least =
      isAsked ? leastForLimits(options_.size, options_.minSize) : gentleLeast * options_.size;
  return bounded(std::min(size, std::max(turn * radius, least)));
}

double DomainSize::bounded(double size) const {
  return std::clamp(size, options_.minSize, options_.maxSize);
}

}  // namespace af2::geometry
