// The kinds of charts that a surface can be seen through, by name.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/base/export.h"

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

/// How a front sees a face through charts of a kind.
enum class ChartDrawing {
  EachStep,      ///< from each base edge anew
  InParameters,  ///< likewise in the parameters, where a vertex of a seam has two places
  WholeFace,     ///< laid out in one plane, by ChartedSurface::makePlaneMap
};

/// One kind of charts. Surfaces say whether they have it (ChartedSurface::has).
struct ChartTraits {
  ChartKind kind;
  const char* name;
  ChartDrawing drawing;
  /// Only for boundaries that are closed curves in the parameters.
  bool needsParameters = false;
  /// What is left of a stuck front may be closed in the parameters.
  bool canCloseInParameters = false;
  /// Whether it is tried though nobody asks for it, on a face that has the kinds `others`.
  bool (*suits)(std::span<const ChartKind> others) = nullptr;
};

/// In the order in which they are tried on a face.
AF2_EXPORT std::span<const ChartTraits> chartKinds();

/// Those that can be asked for, e.g. "auto, mean-normal".
AF2_EXPORT std::string chartNames();
/// "auto", "mean-normal", ...
AF2_EXPORT const char* toString(ChartKind kind);
/// The kind of a name that can be asked for.
AF2_EXPORT std::optional<ChartKind> chartKindOf(std::string_view name);

}  // namespace af2::geometry
