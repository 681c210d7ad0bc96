// An upper bound of the area of a face, for faces whose curves do not give the area.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <TopoDS_Face.hxx>

#include "engine/mesh/front_input.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

/// The area of a sphere as large as the surface or the boundary, and at most that of the surface.
/// On unbounded surfaces, such as cylinders, a face is within its boundary even if the boundary
/// curves are faulty: there the bound is at most the area of the part of the surface that contains
/// the boundary.
double mostArea(const TopoDS_Face& face, const FaceSurface& surface, const FrontInput& boundary);

}  // namespace af2::geometry
