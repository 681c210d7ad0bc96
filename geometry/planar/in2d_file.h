// Planar domains bounded by lines and curves: Netgen's .in2d files.
#pragma once

#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/export.h"
#include "geometry/planar/mesh_planar.h"
#include "geometry/planar/poly_file.h"

namespace af2::geometry {

/// Lines, rational quadratic curves and B-splines, with the domains on their two sides.
struct PlanarCurves {
  struct Curve {
    int from = 0, to = 0;        ///< indices into points
    std::optional<int> control;  ///< control point of a quadratic curve; none: a line
    /// Poles of a B-spline with uniform knots that goes through its first and last pole; order 2:
    /// straight from pole to pole; order 0: not a B-spline.
    std::vector<Point2> poles;
    int order = 0;
    int left = 0, right = 0;  ///< domains; 0: outside
    double maxSize = std::numeric_limits<double>::infinity();
    int boundary = 0;  ///< number of its boundary; 0: none
    int line = 0;      ///< in the file
  };
  std::string name;  ///< the file
  std::vector<Point2> points;
  std::vector<Curve> curves;
  std::map<int, std::string> domainNames;
  std::map<int, double> domainSizes;
  std::map<int, std::string> boundaryNames;
};

/// Reads a file of the kind `splinecurves2dv2`, or the older `splinecurves2d`. Of the flags in the
/// file it uses -maxh of segments and domains, and -bc and -bcname of segments; a boundary with
/// only a name gets a number above all others. Throws InputError with file and line if the file
/// cannot be read.
AF2_EXPORT PlanarCurves readIn2d(const std::filesystem::path& path);

/// A point of a curve, t from 0 to 1. The weight of the control point is chosen so that the curve
/// is an arc of a circle if the control point is equally far from both ends.
AF2_EXPORT Point2 pointOn(const PlanarCurves& curves, const PlanarCurves::Curve& curve, double t);

/// The domains between the curves, each of which is an edge: 1, 2, ... in the order of the file.
AF2_EXPORT PlanarDomain domainOf(const PlanarCurves& curves);

}  // namespace af2::geometry
