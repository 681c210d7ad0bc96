// Numbers drawn by a seed: the same ones on every machine.
#pragma once

#include <cstdint>
#include <gp_Ax2.hxx>
#include <gp_Pnt.hxx>
#include <random>

namespace af2::made {

/// Draws what a model is made of. The distributions of the standard library differ between
/// implementations, hence these.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}

  /// A number from least to most.
  double between(double least, double most) {
    return least + (most - least) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }

  /// An integer from least to most, both included.
  int count(int least, int most) {
    return least + static_cast<int>(engine_() % static_cast<std::uint64_t>(most - least + 1));
  }

  /// True in so many cases of a hundred.
  bool chance(int percent) { return count(1, 100) <= percent; }

  /// A point of the box from -half to half.
  gp_Pnt point(double half) {
    const double x = between(-half, half);
    const double y = between(-half, half);
    return {x, y, between(-half, half)};
  }

  gp_Dir direction() {
    for (;;) {
      const gp_Pnt tip = point(1);
      if (tip.Distance(gp_Pnt()) > 0.1) return gp_Dir(tip.XYZ());
    }
  }

  /// Axes through a point of the box from -half to half: along those of space, or at an odd angle.
  gp_Ax2 axes(double half) {
    const gp_Pnt origin = point(half);
    const gp_Dir along[] = {gp::DX(), gp::DY(), gp::DZ()};
    return chance(50) ? gp_Ax2(origin, along[count(0, 2)]) : gp_Ax2(origin, direction());
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace af2::made
