// Dividing a sampled curve by the sizes wanted along it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/base/point.h"

namespace af2::geometry {

/// Lets sizes grow along a curve by no more than `growth` per unit of length.
///
/// arcLength  of the samples, from the start of the curve
void gradeAlong(std::span<const double> arcLength, std::span<double> sizes, double growth);

/// Number of segments up to each sample, if segments had exactly the wanted sizes.
std::vector<double> segmentsAlong(std::span<const double> arcLength, std::span<const double> sizes);

/// A place on a sampled curve: `within` of the way from sample `cell` to the next.
struct CurvePlace {
  std::size_t cell = 0;
  double within = 0;

  template <class T>
  T between(const std::vector<T>& values) const {
    return values[cell] + within * (values[cell + 1] - values[cell]);
  }
};

/// Where `segments` equal shares of the count end, but for the last.
std::vector<CurvePlace> equalShares(std::span<const double> count, std::size_t segments);

/// By how much, in radians, the tangent turns along a curve, of which these are points.
double turnAlong(std::span<const Point3> points);

/// How many segments a curve gets that is `count` wanted sizes long: the nearest whole number, at
/// least one. Where it turns and turns are to have their elements, so many that no segment is
/// longer than wanted.
///
/// byTurn  as many as its turn asks for alone; 0 if turns are not to have their elements
/// share   of the wanted sizes that those counted in `count` have where the curve turns
std::size_t wholeSegments(double count, double byTurn, double share = 1);

/// The ends of a curve among numbered points.
struct CurveEnds {
  std::size_t first = 0, last = 0;
};

/// Curves that share ends, each with its samples. Grades all of them, also from one to the next.
struct SampledCurve {
  CurveEnds ends;
  std::vector<double> arcLength, sizes;
};
void gradeTogether(std::vector<SampledCurve>& curves, std::size_t points, double growth);

/// How many segments each curve needs at least, so that no two share a segment: three if it is
/// closed, two if another one has the same ends.
std::vector<std::size_t> leastSegments(const std::vector<CurveEnds>& curves);

}  // namespace af2::geometry
