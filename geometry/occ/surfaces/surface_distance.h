// The distance of points from the surface under a CAD face.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <TopoDS_Face.hxx>
#include <memory>

#include "geometry/deviation/face_distance.h"
#include "geometry/occ/surfaces/face_surface.h"

namespace af2::geometry {

/// Null if the surface is plane.
std::unique_ptr<FaceDistance> distanceFromSurface(const TopoDS_Face& face,
                                                  const FaceSurface& surface);

}  // namespace af2::geometry
