// Finds the point of a curve that is nearest to a place.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <BRepAdaptor_Curve.hxx>
#include <algorithm>

#include "geometry/occ/base/points.h"

namespace af2::geometry {

/// The parameter after some Gauss-Newton steps from `start`, kept within the range.
inline double footOnCurve(const BRepAdaptor_Curve& curve, const Point3& place, double start,
                          double low, double high, int steps) {
  double parameter = start;
  for (int step = 0; step < steps; ++step) {
    gp_Pnt at;
    gp_Vec tangent;
    curve.D1(parameter, at, tangent);
    const Point3 d = toPoint(tangent);
    if (!(dot(d, d) > 0)) break;
    parameter = std::clamp(parameter + dot(place - toPoint(at), d) / dot(d, d), low, high);
  }
  return parameter;
}

}  // namespace af2::geometry
