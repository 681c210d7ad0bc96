// Curves through points.
#pragma once

#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_HArray1OfPnt.hxx>

#include <vector>

namespace af2::testing {

/// A spline of degree 1.
inline Handle(Geom_BSplineCurve) polyline(const std::vector<gp_Pnt>& points) {
  const int n = static_cast<int>(points.size());
  TColgp_Array1OfPnt poles(1, n);
  TColStd_Array1OfReal knots(1, n);
  TColStd_Array1OfInteger uses(1, n);
  for (int i = 1; i <= n; ++i) {
    poles(i) = points[static_cast<std::size_t>(i) - 1];
    knots(i) = i;
    uses(i) = i == 1 || i == n ? 2 : 1;
  }
  return new Geom_BSplineCurve(poles, knots, uses, 1);
}

/// A smooth spline of degree 3.
inline Handle(Geom_BSplineCurve) splineThrough(const std::vector<gp_Pnt>& points) {
  const Handle(TColgp_HArray1OfPnt) array =
      new TColgp_HArray1OfPnt(1, static_cast<int>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    array->SetValue(static_cast<int>(i) + 1, points[i]);
  GeomAPI_Interpolate spline(array, false, 1e-9);
  spline.Perform();
  return spline.Curve();
}

}  // namespace af2::testing
