// Finds what makes the surface of a face impossible to mesh well, in the model itself.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <TopoDS_Face.hxx>
#include <optional>
#include <string>

#include "geometry/mesh/model_mesh.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// A place where a surface crosses itself or shrinks to a point and goes on beyond it, two places
/// near each other at which it turns back, or any place of one that is a line.
struct SurfaceFault {
  enum class Kind { Crossing, Fold, Pinch, NoArea };
  Kind kind = Kind::Crossing;
  Point3 place;
  Point3 other;  ///< of a fold: where the surface turns back again
};

/// Samples the surface inside the face. A crossing is confirmed by Newton's method. A fold is found
/// on lines of constant u or v that turn by more than 120 degrees within a tenth of the size, and
/// by as much in the other direction within four sizes. A pinch is a line of constant u or v
/// without length between others, as where a profile that is turned crosses its axis.
std::optional<SurfaceFault> surfaceFault(const TopoDS_Face& face, double size);

/// The same for a face of a model. Planes have none.
///
/// size  edge length of the mesh
std::optional<SurfaceFault> surfaceFault(const ModelShape& model, int face, double size);

/// Whether the surface of a face is a line, so that there is nothing to be meshed.
bool isLine(const TopoDS_Face& face);

/// "in the model itself, ..."
std::string textOf(const SurfaceFault& fault);

}  // namespace af2::geometry
