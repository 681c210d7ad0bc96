// The triangles around an inner vertex, two of them in one register.
// Not installed.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "engine/base/pair.h"
#include "engine/base/point.h"
#include "engine/step/neighborhood.h"

namespace af2 {

/// Where a vertex between triangles should move. VertexSmoother does the same for elements of any
/// kind, one after the other.
class TriangleStar {
 public:
  static constexpr std::size_t kMost = 16;  ///< triangles

  /// Draws the vertices around `here` in a chart there. Returns false if one of them is hidden.
  ///
  /// ring  these vertices, counter-clockwise, three to kMost; they must stay as they are
  bool draw(const SurfacePoint& here, std::span<const SurfacePoint* const> ring,
            const StepChart& chart);
  /// Length of the shortest edge at the vertex, in the chart.
  double reach() const { return reach_; }

  /// A step of Newton's method in the chart, shortened until it lowers the sum of the squared
  /// distortions; (0, 0) if none does.
  ///
  /// relaxation  factor of the first step tried
  Point2 improvedPosition(double relaxation) const;

  /// Whether with the vertex at `here` the distortion of each triangle is certainly below a limit,
  /// and each faces the way the surface does. False also where a vertex has no normal.
  bool isPlainlyBelow(double limit, const SurfacePoint& here) const;

 private:
  template <class Drawing>
  bool draw(const SurfacePoint& here, const StepChart& chart, const Drawing& drawing);
  double energyAt(Point2 x) const;

  std::span<const SurfacePoint* const> ring_;
  std::array<Pair, kMost + 2> drawn_;  ///< the ring; its first two follow again after the last one
  double reach_ = 0;
};

}  // namespace af2
