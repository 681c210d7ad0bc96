// The readers behind planar_file.h, one file each, and the table of them.
// Not installed.
#pragma once

#include <array>

#include "geometry/planar/in2d_file.h"
#include "geometry/planar/planar_file.h"
#include "geometry/planar/poly_file.h"

namespace af2::geometry {

/// In the order in which messages list them.
inline constexpr std::array kPlanarFormats{
    PlanarFormat{{".poly", {".poly"}}, &readPoly},
    PlanarFormat{{".in2d", {".in2d"}},
                 [](const std::filesystem::path& path) { return domainOf(readIn2d(path)); }},
};

}  // namespace af2::geometry
