// Finds pinches: lines of constant u or v inside a face that degenerate to a point.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <vector>

#include "geometry/occ/surfaces/face_cells.h"
#include "geometry/occ/surfaces/parameter_line.h"

namespace af2::geometry {

/// A line across a face whose length is at most this share of the wanted size counts as a point.
inline constexpr double kPinched = 1e-3;

/// Cuts where all lines along a parameter come together at one place and separate again.
///
/// lines      side by side across the face
/// samples    of each line, at the same ascending parameters, dense enough to have one on each side
///            of a pinch
/// longest    maximum distance of the lines at one place
/// whole      the range of the parameter
/// stretches  of this range; none: it is not divided
void cutAtPinches(const std::vector<ParameterLine>& lines,
                  const std::vector<std::vector<ParameterLine::Place>>& samples, double longest,
                  const Stretch& whole, std::vector<Stretch>& stretches);

}  // namespace af2::geometry
