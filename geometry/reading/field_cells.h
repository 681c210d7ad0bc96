// What readers find in a file of which only the values at vertices matter.
// Not installed.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "geometry/sizes/cell_size.h"

namespace af2::geometry {

struct FieldCells {
  std::vector<Point3> vertices;
  /// Of points, segments, triangles and tetrahedra, into which larger cells are cut. Vertices may
  /// be numbers that the file does not have.
  std::vector<std::array<std::uint64_t, 4>> cells;
  /// Values by vertex, by the name of the array; kMissing where the file has none.
  std::map<std::string, std::vector<double>> arrays;
  std::vector<std::string> others;  ///< what else the file has, such as vectors

  static constexpr std::uint64_t kNoCorner = std::numeric_limits<std::uint64_t>::max();
  static constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

  /// A cell of dimension 0 to 3; its corners in the order of VTK and Gmsh, which is the same for
  /// these.
  void add(std::span<const std::uint64_t> corners, int dimension);
  /// The values of an array, for the vertices from `first` on.
  void addValues(const std::string& name, std::size_t first, const std::vector<double>& values);
};

/// Gmsh's post-processing views, text (.pos): a cell for each scalar point, line, triangle and so
/// on, with the values of the first time step. Throws InputError, with file and line.
void readPos(const std::string& name, const std::string& content, FieldCells& field);

}  // namespace af2::geometry
