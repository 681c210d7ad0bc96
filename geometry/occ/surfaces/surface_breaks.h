// Finds parameters at which the derivatives of a surface may jump.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <GeomAdaptor_Surface.hxx>
#include <vector>

namespace af2::geometry {

/// Parameters at which derivatives may jump, ascending. On a periodic surface, they are repeated
/// throughout the range of the face.
///
/// isInU      of u; else v
/// low, high  the range of the parameter that a face occupies
std::vector<double> breaksOf(const GeomAdaptor_Surface& surface, bool isInU, double low,
                             double high);

}  // namespace af2::geometry
