// OpenCASCADE's general fuse: shapes are split where they meet, and the pieces share their faces.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <BOPAlgo_GlueEnum.hxx>
#include <Precision.hxx>
#include <TopoDS_Shape.hxx>
#include <algorithm>
#include <memory>
#include <stop_token>
#include <vector>

namespace af2::geometry {

struct FuseOptions {
  double tolerance = 0;  ///< shapes nearer than this meet; 0: the tolerances of the shapes decide
  BOPAlgo_GlueEnum glue = BOPAlgo_GlueOff;
  double seconds = 60;  ///< time limit
  std::stop_token stop = {};
};

/// The tolerance for a model when none is given: a ten-millionth of its diagonal, at least the
/// precision of OpenCASCADE.
inline double usualFuseTolerance(double diagonal) {
  constexpr double kDiagonalShare = 1e-7;
  return std::max(kDiagonalShare * diagonal, Precision::Confusion());
}

/// Shapes that have been fused.
class GeneralFuse {
 public:
  virtual ~GeneralFuse() = default;
  /// What has become of a solid, face, edge or vertex of the arguments; empty: it has vanished.
  virtual std::vector<TopoDS_Shape> piecesOf(const TopoDS_Shape& shape) = 0;
};

/// Keeps its arguments unchanged. It runs on one thread, because its result with several depends on
/// their order.
///
/// Throws GeometryError, with the reason, if OpenCASCADE fails, is stopped or takes too long.
std::unique_ptr<GeneralFuse> fuseShapes(const std::vector<TopoDS_Shape>& arguments,
                                        const FuseOptions& options);

/// Solids bounded by these faces, in the orientations that they have here.
///
/// Throws GeometryError if there are none.
std::vector<TopoDS_Shape> solidsBetween(const std::vector<TopoDS_Shape>& faces);

/// Whether a piece of a face looks to its other side.
bool isTurned(const TopoDS_Shape& piece, const TopoDS_Shape& face);

}  // namespace af2::geometry
