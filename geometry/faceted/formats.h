// The readers behind readFacets, one file each, and the table of them.
// Not installed.
#pragma once

#include <array>
#include <string>

#include "geometry/faceted/facets.h"

namespace af2::geometry {

/// Each adds the triangles and parts of a file to `facets`, whose name is set; vertices at the same
/// position are not merged yet. Throws InputError, with file and place.
///
/// STL, text or binary, recognised by the content.
void readStl(const std::string& content, Facets& facets);
/// Wavefront OBJ; polygons are cut into triangles.
void readObj(const std::string& content, Facets& facets);

/// In the order in which messages list them.
inline constexpr std::array kFacetFormats{
    FacetFormat{{"STL", {".stl"}}, &readStl},
    FacetFormat{{"OBJ", {".obj"}}, &readObj},
};

}  // namespace af2::geometry
