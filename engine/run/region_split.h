// Cuts one region into pieces that are meshed in parallel: recursive bisection along lines in the
// parameter plane of the surface.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/export.h"
#include "engine/mesh/front_input.h"
#include "engine/surface/size_field.h"

namespace af2 {

/// Evaluates a surface at given parameters, to place the vertices of cuts.
class AF2_EXPORT SurfaceEvaluator {
 public:
  virtual ~SurfaceEvaluator() = default;
  /// Throws GeometryError if there is no point with a normal at (u, v).
  virtual SurfacePoint at(double u, double v) const = 0;
};

/// A piece of a region with its own vertex numbering: a self-contained value.
struct RegionPiece {
  FrontInput input;
  std::vector<VertexId> vertices;  ///< by vertex of the piece: its id in the whole region
  double expectedElements = 0;     ///< from its area and the sizes along its boundary
};

struct IndexRange {
  std::size_t begin = 0, end = 0;
};

/// One cut through the region or a part of it.
struct RegionCut {
  int depth = 0;      ///< number of cuts made before in the part that it divides
  IndexRange own;     ///< in `cutVertices`: the vertices along it
  IndexRange within;  ///< likewise: those along it and along the cuts of the part it divides
  IndexRange pieces;  ///< the pieces of the part that it divides
};

/// The pieces of a region in a fixed order. Each cut edge is a boundary edge of the two pieces
/// beside it, in opposite directions.
struct SplitRegion {
  std::vector<SurfacePoint> cutVertices;  ///< their ids follow those of the region's boundary
  std::vector<RegionPiece> pieces;        ///< only the region itself if a cut does not pay
  std::vector<RegionCut> cuts;            ///< each before the cuts of the parts that it makes
};

struct SplitOptions {
  /// Regions with more expected elements than this are cut. Larger pieces lose less quality along
  /// the cuts; smaller ones keep more threads busy.
  double pieceElements = 80000;
  /// For quadrilaterals: whether cuts get one edge more or less where this makes loops around the
  /// pieces even. If those around the region are even, all are. Cuts then also lead straight
  /// across, so that grids are cut into grids.
  bool evenPieces = false;
};

/// Depends only on its arguments: the pieces are the same for any number of threads.
///
/// The corners' parameters must describe the region correctly: loops that do not cross, outer ones
/// counter-clockwise (all reversed if the face is reversed). Where a cut would come too close to
/// the boundary, another is tried; a region without a suitable cut stays whole.
AF2_EXPORT SplitRegion splitRegion(const FrontInput& input, const SurfaceEvaluator& surface,
                                   const SizeField& size, const SplitOptions& options = {});

}  // namespace af2
