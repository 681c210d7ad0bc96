// How far a vertex moves, whatever the elements around it are.
// Not installed.
#pragma once

#include <cmath>

#include "engine/base/point.h"

namespace af2 {

/// What is to become small, as a function of the vertex's place in a chart, at the origin.
struct Energy {
  double value = 0;
  Point2 gradient;
  double xx = 0, xy = 0, yy = 0;  // second derivatives
};

/// No vertex moves by more than this fraction of its shortest edge at once.
inline constexpr double kMaxOfReach = 0.5;

/// The factor by which an edge is drawn longer, so that it is as long as it is in space. The plane
/// of a chart leans towards the neighbour that it was made with. Edges that leave it look shorter
/// than they are, and the vertex would drift at each visit. Where elements are small, this needs no
/// root.
///
/// squared, seen  lengths in space and in the chart, squared, in the same unit
inline double stretchOf(double squared, double seen) {
  constexpr double kAsLong = 1e-3;
  return seen > 0 && std::abs(squared - seen) > kAsLong * squared ? std::sqrt(squared / seen) : 1;
}

/// A step of Newton's method from the origin; down the slope where this has no minimum to go to.
///
/// reach       length of the shortest edge at the vertex
/// relaxation  factor of the step
inline Point2 newtonStep(const Energy& e, double reach, double relaxation) {
  const double det = e.xx * e.yy - e.xy * e.xy;
  Point2 step;
  if (e.xx > 0 && det > 0) {
    step = {-(e.yy * e.gradient.x - e.xy * e.gradient.y) / det,
            -(e.xx * e.gradient.y - e.xy * e.gradient.x) / det};
  } else {
    const double slope = length(e.gradient);
    if (!(slope > 0)) return {};
    step = (-0.25 * reach / slope) * e.gradient;
  }
  step = relaxation * step;
  const double size = length(step);
  return size > kMaxOfReach * reach ? (kMaxOfReach * reach / size) * step : step;
}

/// A step that lowers the energy, and the energy there.
struct Descent {
  Point2 step;
  double energy;
};

/// The step, halved until it lowers the energy; (0, 0) if that does not help.
///
/// before    energy at the origin
/// energyAt  energy at a point of the chart
template <class EnergyAt>
Descent descent(Point2 step, double before, const EnergyAt& energyAt) {
  constexpr int kHalvings = 4;
  for (int i = 0; i < kHalvings; ++i, step = 0.5 * step) {
    const double energy = energyAt(step);
    if (energy < before) return {step, energy};
  }
  return {{}, before};
}

}  // namespace af2
