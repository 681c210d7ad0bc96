#include "geometry/domain/domain_size.h"

#include <algorithm>
#include <numbers>

namespace af2::geometry {

DomainSize::DomainSize(const Sizes& sizes) : asked_(&sizes), function_(sizes.function) {
  if (!sizes.sources.isEmpty())
    sources_ = std::make_shared<const PositionSize>(sizeFrom(sizes.sources, sizes.growth));
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

double DomainSize::leastAtTurns(double gentleLeast) const {
  return asked_->elementsPerTurn > 0 ? leastForLimits(asked_->size, asked_->minSize)
                                     : gentleLeast * asked_->size;
}

double DomainSize::turnLimit(double radius, double gentleLeast) const {
  const ChordBound& chord = asked_->chords.everywhere;
  double height = chord.isShareOfSize ? chord.value * asked_->size : chord.value;
  double aim = 1;
  for (const auto& [face, ofFace] : asked_->chords.aims) aim = std::min(aim, ofFace);
  height *= aim;
  const double limit = std::max(limitOfTurn() * radius, leastAtTurns(gentleLeast));
  return chord.isGiven() ? std::min(limit, longestChord(radius, height)) : limit;
}

double DomainSize::turnOfSegment() const {
  return asked_->elementsPerTurn > 0 ? 2 * std::numbers::pi / asked_->elementsPerTurn : 0;
}

double DomainSize::limitOfTurn() const {
  constexpr double kGentleTurn = std::numbers::pi / 4;
  return asked_->elementsPerTurn > 0 ? turnOfSegment() : kGentleTurn;
}

double DomainSize::bounded(double size) const { return geometry::bounded(*asked_, size); }

}  // namespace af2::geometry
