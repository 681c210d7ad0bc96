// Faces of an IGES file with curves that OpenCASCADE put a period beside their place.
#pragma once

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <functional>

namespace af2::geometry {

/// Whether the boundary takes more than a period of a closed surface. Helices do so as well.
bool runsPastPeriod(const TopoDS_Face& face);

/// Puts faces of another reading of the same file in the place of those that take more than a
/// period, where they do not do so in that one. Returns how many. `readAgain` is called if there is
/// any such face.
///
/// A boundary has a curve in space and one in the parameters for each edge. Where the reader takes
/// those in space for better, it finds the side of the seam that others lie on by their ends, which
/// may be on both; arcs then bulge out of the surface instead of into it, or circles go around
/// twice.
int replaceShifted(TopoDS_Shape& shape, const std::function<TopoDS_Shape()>& readAgain);

}  // namespace af2::geometry
