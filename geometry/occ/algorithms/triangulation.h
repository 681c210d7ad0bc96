// OpenCASCADE's triangulation of shapes.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <TopoDS_Shape.hxx>

namespace af2::geometry {

/// Gives the faces of the shape triangulations, on one thread.
///
/// deflection  largest distance from the shape
/// turn        largest angle between neighbouring pieces of a curve, in radians
///
/// Throws Standard_Failure if OpenCASCADE fails.
void triangulate(const TopoDS_Shape& shape, double deflection, double turn);

}  // namespace af2::geometry
