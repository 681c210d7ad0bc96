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
/// Mesh files; quadrilaterals are split, and faces of the mesh are parts, with their names if they
/// have any: geometry/reading/.
void readMshFacets(const std::string& content, Facets& facets);
void readVtuFacets(const std::string& content, Facets& facets);
void readVtkFacets(const std::string& content, Facets& facets);
void readPlyFacets(const std::string& content, Facets& facets);
void readOffFacets(const std::string& content, Facets& facets);

/// In the order in which messages list them.
inline constexpr std::array kFacetFormats{
    FacetFormat{{"STL", {".stl"}}, &readStl},
    FacetFormat{{"OBJ", {".obj"}}, &readObj},
    FacetFormat{{"PLY", {".ply"}}, &readPlyFacets},
    FacetFormat{{"OFF", {".off"}}, &readOffFacets},
    FacetFormat{{"Gmsh", {".msh", ".msh2"}}, &readMshFacets},
    FacetFormat{{"VTK XML", {".vtu"}}, &readVtuFacets},
    FacetFormat{{"VTK", {".vtk"}}, &readVtkFacets},
};

}  // namespace af2::geometry
