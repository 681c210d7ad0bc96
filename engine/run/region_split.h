// Cuts one region into pieces that can be meshed at the same time: recursive bisection along lines
// in the parameter plane of the surface.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/export.h"
#include "engine/mesh/front_input.h"
#include "engine/surface/size_field.h"

namespace af2 {

/// Gives points of a surface from its parameters, for placing the vertices of cuts.
class AF2_EXPORT SurfaceEvaluator {
 public:
  virtual ~SurfaceEvaluator() = default;
  /// Throws GeometryError if there is no point with a normal at (u, v).
  virtual SurfacePoint at(double u, double v) const = 0;
};

/// A piece of a region, with vertices numbered on its own: a self-contained value.
struct RegionPiece {
  FrontInput input;
  std::vector<VertexId> vertices;  ///< by vertex of the piece: its id in the whole region
  double expectedElements = 0;     ///< by its area and the sizes along its boundary
};

struct IndexRange {
  std::size_t begin = 0, end = 0;
};

/// One cut through the region or a part of it.
struct RegionCut {
  int depth = 0;      ///< how many cuts were made before in what it divides
  IndexRange own;     ///< of `cutVertices`: along it
  IndexRange within;  ///< likewise: along it, and along the cuts of what it divides
  IndexRange pieces;  ///< what becomes of what it divides
};

/// The pieces of a region in a fixed order. Their cut edges are boundary edges of the two pieces
/// that they lie between, in opposite directions.
struct SplitRegion {
  std::vector<SurfacePoint> cutVertices;  ///< their ids follow those of the region's boundary
  std::vector<RegionPiece> pieces;        ///< one, the region itself, if it was not worth a cut
  std::vector<RegionCut> cuts;            ///< each before those of what it divides
};

struct SplitOptions {
  /// Regions that are expected to get more elements than this are cut. Larger pieces lose less
  /// quality along the cuts; smaller ones keep more threads busy.
  double pieceElements = 80000;
};

/// Depends on nothing but its arguments: the pieces are the same for any number of threads.
///
/// The parameters of the corners must draw the region as it is: loops that do not cross each other,
/// outer ones counter-clockwise or, if the face is reversed, all the other way round. Where a cut
/// would come too close to the boundary another one is tried; a region that has none stays whole.
AF2_EXPORT SplitRegion splitRegion(const FrontInput& input, const SurfaceEvaluator& surface,
                                   const SizeField& size, const SplitOptions& options = {});

}  // namespace af2
