// Repairs faces of an IGES file whose curves OpenCASCADE shifted by a period.
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <functional>

namespace af2::geometry {

/// Whether the boundary spans more than a period of a closed surface. Helices also do.
bool runsPastPeriod(const TopoDS_Face& face);

/// Replaces faces that span more than a period by those of a second reading of the same file, where
/// they do not. Returns the number of replaced faces. `readAgain` is called if there is any such
/// face.
///
/// A boundary has a curve in space and one in the parameters for each edge. Where the reader
/// prefers the curves in space, it chooses the side of the seam by the ends of the curves, which
/// may be on both sides; arcs then bulge out of the surface instead of into it, or circles go
/// around twice.
int replaceShifted(TopoDS_Shape& shape, const std::function<TopoDS_Shape()>& readAgain);

}  // namespace af2::geometry
