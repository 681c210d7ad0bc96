// The kinds of charts of a surface, by name.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/base/export.h"

namespace af2::geometry {

/// docs/charts.md explains and compares them.
enum class ChartKind {
  Auto,           ///< chosen by surface and sizes
  Plane,          ///< the plane itself, for plane faces
  MeanNormal,     ///< the published plane across the mean normal of the base edge
  NormalLines,    ///< on the same plane, along the normals of the surface
  Parametric,     ///< geodesic coordinates from the surface's parameters, to second order
  Affine,         ///< the parameters with the metric at the base edge: straight lines stay straight
  Developed,      ///< cylinders, cones and extrusions unrolled
  Stereographic,  ///< spheres from the point opposite the base edge
  Conformal,      ///< surfaces of revolution laid out so that angles are kept and lengths vary
};

/// How a front uses the charts of a kind on a face.
enum class ChartDrawing {
  EachStep,      ///< a new chart for each base edge
  InParameters,  ///< likewise, but in the parameters, where a vertex on a seam has two places
  WholeFace,     ///< the whole face in one plane, by ChartedSurface::makePlaneMap
};

/// One kind of charts. Surfaces say whether they have it (ChartedSurface::has).
struct ChartTraits {
  ChartKind kind;
  const char* name;
  ChartDrawing drawing;
  /// Only for boundaries that are closed curves in the parameters.
  bool needsParameters = false;
  /// Whether the rest of a stuck front may be closed in the parameters.
  bool canCloseInParameters = false;
  /// Whether the kind is tried without a request, on a face that also has the kinds `others`.
  bool (*suits)(std::span<const ChartKind> others) = nullptr;
};

/// In the order in which they are tried on a face.
AF2_EXPORT std::span<const ChartTraits> chartKinds();

/// The names that a user can request, e.g. "auto, mean-normal".
AF2_EXPORT std::string chartNames();
/// "auto", "mean-normal", ...
AF2_EXPORT const char* toString(ChartKind kind);
/// The kind that a user can request by this name; none if there is none.
AF2_EXPORT std::optional<ChartKind> chartKindOf(std::string_view name);

}  // namespace af2::geometry
