// The readers behind readFacets, one file each, and the table of them.
// Not installed.
#pragma once

#include <array>
#include <string>

#include "geometry/faceted/facets.h"

namespace af2::geometry {

/// Each adds the triangles and parts of a file to `facets`, which has its name, without regard to
/// vertices at the same position. Throws InputError, with file and place.
///
/// STL, text or binary, which its content says.
void readStl(const std::string& content, Facets& facets);
/// Wavefront OBJ; polygons are cut into triangles.
void readObj(const std::string& content, Facets& facets);

/// In the order in which texts name them.
inline constexpr std::array kFacetFormats{
    FacetFormat{{"STL", {".stl"}}, &readStl},
    FacetFormat{{"OBJ", {".obj"}}, &readObj},
};

}  // namespace af2::geometry
