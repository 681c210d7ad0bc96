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

/// The corners of triangles: numbers of vertices, counter-clockwise seen from outside.
using FacetTriangles = std::vector<std::array<std::uint32_t, 3>>;

/// Triangles between shared vertices.
struct Facets {
  std::string name;  ///< the file, or any name, for messages
  std::vector<Point3> vertices;
  FacetTriangles triangles;
  /// By triangle: its part in the file; empty: the file names no parts.
  std::vector<std::uint32_t> group;
  std::vector<std::string> groupNames;  ///< by part; may be empty
  std::vector<std::string> notes;       ///< faults that were repaired
};

struct AF2_EXPORT FacetFormat : FileFormat {
  /// From the content of a file.
  void (*read)(const std::string& content, Facets& facets);
};

/// In the order in which messages list them.
AF2_EXPORT std::span<const FacetFormat> facetFormats();

/// Reads an STL, OBJ, PLY or OFF file or a mesh file, chosen by the extension. Vertices at the same
/// position are merged, triangles that use one of them twice are left out, and polygons of an OBJ
/// file and quadrilaterals are cut into triangles. The solids of a text STL file, the groups and
/// objects of an OBJ file, and the faces of a mesh file, become parts. Small faults are repaired
/// (repairFacets) and noted.
///
/// Throws InputError, with file and place, if the file cannot be read or no triangle is left after
/// the repairs.
AF2_EXPORT Facets readFacets(const std::filesystem::path& path);

/// The same for triangles that are in memory: vertices at the same position are merged, triangles
/// that use one of them twice and vertices without triangles are left out, and small faults are
/// repaired and noted. meshFaceted expects facets without such faults.
///
/// Throws InputError if a triangle has a corner that is no vertex, if a coordinate is not a finite
/// number, if `group` is neither empty nor of the length of `triangles` or has a part without an
/// entry in `groupNames`, or if no triangle is left.
AF2_EXPORT Facets repairedFacets(Facets facets);

}  // namespace af2::geometry
