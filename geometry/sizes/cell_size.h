// Sizes at the vertices of a mesh, linear within its cells: a background field of any shape.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/base/export.h"
#include "engine/base/point.h"

namespace af2::geometry {

/// Sizes on points, segments, triangles and tetrahedra.
struct SizeCells {
  static constexpr std::uint32_t kNone = 0xffffffffu;

  std::vector<Point3> vertices;
  std::vector<double> sizes;  ///< by vertex, > 0
  /// Numbers of vertices: one for a point, two for a segment, and so on; the others are kNone.
  std::vector<std::array<std::uint32_t, 4>> cells;
};

/// Throws InputError unless there are cells, all between vertices, with finite places and sizes >
/// 0.
AF2_EXPORT void checkCells(const SizeCells& cells);

/// The size at any place: interpolated in the cell there; outside, that at the nearest point of a
/// cell. Where the sizes of the vertices of a cell grow faster than `growth` per unit of length,
/// the larger ones are lowered.
class CellSize {
 public:
  CellSize(SizeCells cells, double growth);
  double at(const Point3& p) const;

 private:
  struct Prepared;
  std::shared_ptr<const Prepared> prepared_;
};

}  // namespace af2::geometry
