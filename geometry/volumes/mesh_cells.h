// The cells into which the triangles of a mesh divide space.
// Not installed.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

using Triangle = std::array<VertexId, 3>;

/// Two cells touch only across triangles: triangles that share an edge separate the same cells
/// there. More than two triangles may meet at an edge, and an edge of one triangle is open: the
/// triangle then has the same cell on both sides.
struct MeshCells {
  static constexpr std::uint32_t kOutside = 0;  ///< the unbounded cell
  /// By side of a triangle: the cell on that side. Side 2 t of triangle t is the one that its
  /// normal points to, 2 t + 1 the other one. Cells have the numbers 1, 2, ... in the order of
  /// their first sides.
  std::vector<std::uint32_t> ofSide;
  /// By cell: a point strictly inside. None for the unbounded cell, and if triangles cross or lie
  /// on each other so that no such point was found.
  std::vector<std::optional<Point3>> inside;
};

enum class PointsInside { Wanted, NotNeeded };

/// Points inside take most of the time.
MeshCells cellsOf(const std::vector<Point3>& vertices, const std::vector<Triangle>& triangles,
                  PointsInside points = PointsInside::Wanted);

}  // namespace af2::geometry
