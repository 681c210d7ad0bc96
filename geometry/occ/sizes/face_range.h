// Where in its parameters a face is.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <TopoDS_Face.hxx>

#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

/// A range of OpenCASCADE's parameters that holds the face. FaceSurface::box() does not tell for
/// planes.
SplineSurface::Box rangeOf(const TopoDS_Face& face, const FaceSurface& surface);

}  // namespace af2::geometry
