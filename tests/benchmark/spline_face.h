// A face of bicubic B-splines, for benchmarks.
#pragma once

#include <BRepBuilderAPI_MakeFace.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS_Face.hxx>
#include <cmath>

namespace af2::benchmark {

/// About 10 x 10, of 20 x 20 spans, with waves; the least radius of curvature is about 1.3.
inline TopoDS_Face splineFace() {
  constexpr int kSpans = 20, kDegree = 3, kPoles = kSpans + kDegree;
  TColStd_Array1OfReal knots(1, kSpans + 1);
  TColStd_Array1OfInteger multiplicities(1, kSpans + 1);
  for (int k = 1; k <= kSpans + 1; ++k) {
    knots(k) = k - 1;
    multiplicities(k) = k == 1 || k == kSpans + 1 ? kDegree + 1 : 1;
  }
  TColgp_Array2OfPnt poles(1, kPoles, 1, kPoles);
  constexpr double kStep = 10.0 / (kPoles - 1);
  for (int i = 1; i <= kPoles; ++i)
    for (int j = 1; j <= kPoles; ++j) {
      const double x = kStep * (i - 1), y = kStep * (j - 1);
      poles(i, j) = gp_Pnt(x, y, 0.5 * std::sin(0.9 * x + 0.2 * y) * std::cos(0.7 * y));
    }
  return BRepBuilderAPI_MakeFace(new Geom_BSplineSurface(poles, knots, knots, multiplicities,
                                                         multiplicities, kDegree, kDegree),
                                 1e-7)
      .Face();
}

}  // namespace af2::benchmark
