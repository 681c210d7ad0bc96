// Measures the quality of the elements of a mesh, for the report.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/base/export.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// The shape quality of an element: 1 is ideal, 0 is degenerate.
///
/// Triangles: 4 sqrt(3) area / sum of squared edges. Quadrilaterals: the least value over the
/// corners of 2 |p x q| / (p.p + q.q), with p and q the edges at the corner; negative at an
/// inverted corner. A square has 1, a rectangle of 1 : 2 has 0.8, a rhombus the sine of its angle.
AF2_EXPORT double shapeQuality(const std::vector<Point3>& vertices, const Element& element);
AF2_EXPORT double shapeQuality(const MeshSlice& slice, const Element& element);

/// Statistics of edge length over wanted length.
struct LengthRatio {
  /// The histogram counts the edges below the first bound, between each two, and above the last.
  static constexpr std::array kBounds{0.25, 0.35, 0.5, 0.71, 1.0, 1.41, 2.0, 2.83, 4.0};

  double mean = 0, p5 = 0, p95 = 0;
  std::array<std::size_t, kBounds.size() + 1> histogram{};
  double leastWanted = 0, mostWanted = 0;  ///< the smallest and the largest wanted length
  double leastLength = 0, mostLength = 0;  ///< the shortest and the longest edge
};

/// All zero for a mesh without elements.
struct MeshQuality {
  double min = 0, p1 = 0, mean = 0;   ///< of shapeQuality; p1 is the 1st percentile
  std::int32_t worstFace = 0;         ///< model face of the first element of quality `min`
  Point3 worstPlace;                  ///< middle of this element
  double minAngle = 0, maxAngle = 0;  ///< between the edges at a corner, in degrees
  LengthRatio edges;                  ///< each edge of the mesh counts once
  std::size_t freeEdges = 0;          ///< with one element; 0: the mesh is closed
};

/// The length of an edge is compared with the mean of the sizes wanted at its ends; the length
/// statistics are all zero if the mesh does not contain these. Sums over a mesh on disk are added
/// in another order, which may change the last digits of means. Uses up to `threads` threads (0: as
/// many as the caller's TBB arena has).
AF2_EXPORT MeshQuality measureQuality(const ModelMesh& mesh, int threads = 1);

/// The value below which the fraction `part` (0 to 1) of `values` is, by linear interpolation
/// between neighbours; 0 if there are none. Reorders `values`.
AF2_EXPORT double percentile(std::span<double> values, double part);

}  // namespace af2::geometry
