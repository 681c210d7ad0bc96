// A surface that is given by triangles.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/point.h"
#include "geometry/base/file_extension.h"

namespace af2::geometry {

using FacetEdge = std::pair<std::uint32_t, std::uint32_t>;  ///< the lower vertex first

/// Their corners: numbers of vertices, counter-clockwise seen from outside.
using FacetTriangles = std::vector<std::array<std::uint32_t, 3>>;

/// Triangles between shared vertices.
struct Facets {
  std::string name;  ///< the file
  std::vector<Point3> vertices;
  FacetTriangles triangles;
  /// By triangle: the part that the file puts it in; empty: it names none.
  std::vector<std::uint32_t> group;
  std::vector<std::string> groupNames;  ///< by part; may be empty
  std::vector<std::string> notes;       ///< what was not as it should be and was put right
};

struct AF2_EXPORT FacetFormat : FileFormat {
  /// From the content of a file.
  void (*read)(const std::string& content, Facets& facets);
};

/// In the order in which texts name them.
AF2_EXPORT std::span<const FacetFormat> facetFormats();

/// Reads an STL file, text or binary, or an OBJ file; which of them, its extension says. Vertices
/// at the same position are one, triangles that name one of them twice are left out, polygons of an
/// OBJ file are cut into triangles. The solids of a text STL file, and the groups and objects of an
/// OBJ file, are parts. Small faults are put right (repairFacets), and told.
///
/// Throws InputError, with file and place, if it cannot be read or holds no triangle, or none that
/// is left after that.
AF2_EXPORT Facets readFacets(const std::filesystem::path& path);

}  // namespace af2::geometry
