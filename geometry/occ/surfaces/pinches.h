// Lines of constant u or v inside a face that are points: there it goes on from tip to tip.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <vector>

#include "geometry/occ/surfaces/face_cells.h"
#include "geometry/occ/surfaces/parameter_line.h"

namespace af2::geometry {

/// A line across a face that is no longer than this share of the wanted size is a point.
inline constexpr double kPinched = 1e-3;

/// Cuts where all lines that run along a parameter come to the same place, and part again.
///
/// lines      side by side across the face
/// samples    of the parameter, ascending, so dense that there is one on each side of a pinch
/// longest    how far apart the lines may be at one place
/// whole      the range of the parameter
/// stretches  of it; none: it is in one piece
void cutAtPinches(const std::vector<ParameterLine>& lines, const std::vector<double>& samples,
                  double longest, const Stretch& whole, std::vector<Stretch>& stretches);

}  // namespace af2::geometry
