// The part of the parameters that a face takes up, cut into cells along its creases and pinches.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace af2::geometry {

/// A range of a parameter without creases inside. Between an end of it and its calm part the
/// surface turns in less than an element can follow: there normals and radii are those of the calm
/// part.
struct Stretch {
  double low = 0, high = 0;
  double calmLow = 0, calmHigh = 0;

  double calm(double parameter) const { return std::clamp(parameter, calmLow, calmHigh); }
  bool has(double parameter) const { return parameter >= low && parameter <= high; }
};

/// Where a stretch ends if the next one begins at `parameter`: a spline at a knot is what comes
/// after it.
inline double justBefore(double parameter, double range) {
  constexpr double kInside = 1e-9;  // of the range
  return parameter - kInside * range;
}

/// The part of the parameters that a face takes up, cut along its creases. [k] ends where [k + 1]
/// begins.
struct FaceCells {
  std::vector<Stretch> u, v;

  bool isOne() const { return u.size() <= 1 && v.size() <= 1; }
  std::size_t count() const { return u.size() * v.size(); }
};

/// One of the cells into which its creases cut a face: [u] and [v] of its stretches.
struct FaceCell {
  std::size_t u = 0, v = 0;
};

/// Whether a place is in a cell, or beside it by no more than some share of the parameters.
bool isIn(const FaceCell& cell, const FaceCells& cells, double u, double v, double share = 0);

/// The parameter, taken out of the creases.
double calm(const std::vector<Stretch>& stretches, double parameter);

}  // namespace af2::geometry
