// Divides a sampled curve by the sizes wanted along it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "engine/base/point.h"

namespace af2::geometry {

/// Limits the growth of sizes along a curve to `growth` per unit of length.
///
/// arcLength  of the samples, from the start of the curve
void gradeAlong(std::span<const double> arcLength, std::span<double> sizes, double growth);

/// The number of segments up to each sample, as a fraction, if segments had exactly the wanted
/// sizes.
std::vector<double> segmentsAlong(std::span<const double> arcLength, std::span<const double> sizes);

/// A place on a sampled curve: the fraction `within` of the way from sample `cell` to the next.
struct CurvePlace {
  std::size_t cell = 0;
  double within = 0;

  template <class T>
  T between(const std::vector<T>& values) const {
    return values[cell] + within * (values[cell + 1] - values[cell]);
  }
};

/// The ends of `segments` equal shares of the count, except the last.
std::vector<CurvePlace> equalShares(const std::vector<double>& count, std::size_t segments);

/// The same for the part between two counts: the ends of its shares, except the last.
std::vector<CurvePlace> equalShares(const std::vector<double>& count, double from, double to,
                                    std::size_t segments);

/// The place at a length from the start, which must be on the curve.
CurvePlace placeAt(std::span<const double> arcLength, double length);

/// The angle, in radians, by which the tangent turns along a curve through these points.
double turnAlong(std::span<const Point3> points);

/// The number of segments of a curve that is `count` wanted sizes long: the nearest whole number,
/// at least one. If the curve turns and turns need a minimum number of elements, the number is
/// rounded up so that no segment is longer than wanted.
///
/// byTurn  the number that its turn alone needs; 0 if turns need no minimum number
/// share   ratio of the sizes counted in `count` to the wanted sizes where the curve turns
std::size_t wholeSegments(double count, double byTurn, double share = 1);

/// The number below which a segment of a curve that turns would be longer than wanted, with the
/// arguments of `wholeSegments`; one if the curve hardly turns.
std::size_t fewestSegments(double count, double byTurn, double share = 1);

/// The ends of a curve among numbered points.
struct CurveEnds {
  std::size_t first = 0, last = 0;
};

/// Curves that share ends, each with its samples. Sizes are graded along all of them, and from one
/// to the next.
struct SampledCurve {
  CurveEnds ends;
  std::vector<double> arcLength, sizes;
};
void gradeTogether(std::vector<SampledCurve>& curves, std::size_t points, double growth);

/// The least number of segments of each curve, so that no two curves share a segment: three if it
/// is closed, two if another one has the same ends.
std::vector<std::size_t> leastSegments(const std::vector<CurveEnds>& curves);

}  // namespace af2::geometry
