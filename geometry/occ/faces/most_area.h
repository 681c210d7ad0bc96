// What the area of a face can be at most, where its curves do not tell.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <TopoDS_Face.hxx>

#include "engine/mesh/front_input.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

/// That of a sphere which is as large as the surface or the boundary. On surfaces that do not end
/// by themselves, such as cylinders, faces lie within their boundaries, whatever the curves of
/// these say: there it is no more than that of the part of the surface that holds the boundary.
double mostArea(const TopoDS_Face& face, const FaceSurface& surface, const FrontInput& boundary);

}  // namespace af2::geometry
