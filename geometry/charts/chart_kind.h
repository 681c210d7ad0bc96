// The kinds of charts that a surface can be seen through, by name.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace af2::geometry {

/// docs/charts.md tells what they are and compares them.
enum class ChartKind {
  Auto,           ///< chosen by surface and sizes
  Plane,          ///< the plane itself, for plane faces
  MeanNormal,     ///< the published plane across the mean normal of the base edge
  NormalLines,    ///< on the same plane, along the normals of the surface
  Parametric,     ///< geodesic coordinates in the parameters, to second order
  Affine,         ///< the parameters with the metric at the base edge: straight lines stay straight
  Developed,      ///< cylinders, cones and extrusions unrolled
  Stereographic,  ///< spheres from the point opposite the base edge
  Conformal,      ///< surfaces of revolution laid out with lengths that vary, but no angles
};

/// Those that can be asked for, e.g. "auto, mean-normal".
std::string chartNames();
/// "auto", "mean-normal", ...
const char* toString(ChartKind kind);
/// The kind of a name that can be asked for.
std::optional<ChartKind> chartKindOf(std::string_view name);

}  // namespace af2::geometry
