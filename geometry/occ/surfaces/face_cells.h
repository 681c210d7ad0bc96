// The part of the parameters that a face occupies, cut into cells along its creases and pinches.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace af2::geometry {

/// A range of a parameter without creases inside. Between an end of it and its calm part the
/// surface turns within less than an element can resolve; there the normals and radii of the calm
/// part are used.
struct Stretch {
  double low = 0, high = 0;
  double calmLow = 0, calmHigh = 0;

  double calm(double parameter) const { return std::clamp(parameter, calmLow, calmHigh); }
  bool has(double parameter) const { return parameter >= low && parameter <= high; }
};

/// The end of a stretch if the next one begins at `parameter`. It is slightly before that, because
/// a spline at a knot has the values of the span after it.
inline double justBefore(double parameter, double range) {
  constexpr double kInside = 1e-9;  // of the range
  return parameter - kInside * range;
}

/// The part of the parameters that a face occupies, cut along its creases. [k] ends where [k + 1]
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

/// Whether a place of the face is in a cell, or outside it by at most a share of the parameters.
/// Rounding may put places of the boundary outside the parameters of the face: they are in the
/// cells at that end.
bool isIn(const FaceCell& cell, const FaceCells& cells, double u, double v, double share = 0);

/// The parameter, moved out of the creases into the nearest calm part.
double calm(const std::vector<Stretch>& stretches, double parameter);

}  // namespace af2::geometry
