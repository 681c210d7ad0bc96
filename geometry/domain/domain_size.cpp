#include "geometry/domain/domain_size.h"

#include <algorithm>
#include <numbers>

namespace af2::geometry {

DomainSize::DomainSize(const DomainMeshingOptions& options)
    : options_(&options), function_(options.function) {
  if (!options.sources.isEmpty())
    sources_ = std::make_shared<const PositionSize>(sizeFrom(options.sources, options.growth));
}

DomainSize DomainSize::withFunction(PositionSize function) const {
  DomainSize size = *this;
  size.function_ = std::move(function);
  return size;
}

double DomainSize::at(const Point3& position, double size) const {
  if (function_) size = std::min(size, function_.at(position));
  if (sources_) size = std::min(size, sources_->at(position));
  return bounded(size);
}

double DomainSize::turnLimit(double radius, double gentleLeast) const {
  constexpr double kGentleTurn = std::numbers::pi / 4;
  const bool isAsked = options_->elementsPerTurn > 0;
  const double turn = isAsked ? turnOfSegment() : kGentleTurn;
  const double least =
      isAsked ? leastForLimits(options_->size, options_->minSize) : gentleLeast * options_->size;
  return std::max(turn * radius, least);
}

double DomainSize::turnOfSegment() const {
  return options_->elementsPerTurn > 0 ? 2 * std::numbers::pi / options_->elementsPerTurn : 0;
}

double DomainSize::bounded(double size) const {
  return std::clamp(size, options_->minSize, options_->maxSize);
}

}  // namespace af2::geometry
