// Where the derivatives of a surface may jump.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <GeomAdaptor_Surface.hxx>
#include <vector>

namespace af2::geometry {

/// Parameters at which derivatives may jump, ascending. Those of a periodic surface are wanted
/// wherever its face lies.
///
/// isInU      of u; else v
/// low, high  the range of the parameter that a face takes up
std::vector<double> breaksOf(const GeomAdaptor_Surface& surface, bool isInU, double low,
                             double high);

}  // namespace af2::geometry
