// Planar domains bounded by lines and curves: Netgen's .in2d files.
#pragma once

#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/planar/mesh_planar.h"
#include "geometry/planar/poly_file.h"

namespace af2::geometry {

/// Lines and rational quadratic curves, with the domains on both sides.
struct PlanarCurves {
  struct Curve {
    int from = 0, to = 0;        ///< indices into points
    std::optional<int> control;  ///< a curve towards this point; none: a line
    int left = 0, right = 0;     ///< domains; 0: outside
    double maxSize = std::numeric_limits<double>::infinity();
    int line = 0;  ///< in the file
  };
  std::string name;  ///< the file
  std::vector<Point2> points;
  std::vector<Curve> curves;
  std::map<int, std::string> domainNames;
  std::map<int, double> domainSizes;
};

/// Reads a file of the kind `splinecurves2dv2`, or the older `splinecurves2d`. Of its flags -maxh
/// is used, of segments and domains. Throws InputError with file and line if it cannot be read.
PlanarCurves readIn2d(const std::filesystem::path& path);

/// A point of a curve, t from 0 to 1. The weight of the control point makes an arc of a circle
/// wherever the control point is equally far from both ends.
Point2 pointOn(const PlanarCurves& curves, const PlanarCurves::Curve& curve, double t);

/// Divides each curve once by the sizes wanted along it: those of `options`, of the curve and of
/// the domains beside it. To be meshed with keepBoundary.
PlanarDomain divideCurves(const PlanarCurves& curves, const PlanarMeshingOptions& options);

}  // namespace af2::geometry
