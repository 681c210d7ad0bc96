// A surface that is given by triangles.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/point.h"

namespace af2::geometry {

/// Triangles between shared vertices; counter-clockwise seen from outside.
struct Facets {
  std::string name;  ///< the file
  std::vector<Point3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Reads an STL file, text or binary, or an OBJ file; which of them, its extension says. Vertices
/// at the same position are one, triangles that name one of them twice are left out, polygons of an
/// OBJ file are cut into triangles.
///
/// Throws InputError, with file and place, if it cannot be read or holds no triangle.
Facets readFacets(const std::filesystem::path& path);

}  // namespace af2::geometry
