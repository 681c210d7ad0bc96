// OpenCASCADE's general fuse: shapes are split where they meet, and the pieces share their faces.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <BOPAlgo_Builder.hxx>
#include <TopoDS_Shape.hxx>
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
double usualFuseTolerance(double diagonal);

/// Keeps its arguments unchanged. It runs on one thread, because its result with several depends on
/// their order.
class GeneralFuse {
 public:
  /// Throws GeometryError, with the reason, if OpenCASCADE fails, is stopped or takes too long.
  GeneralFuse(const std::vector<TopoDS_Shape>& arguments, const FuseOptions& options);

  /// What has become of a solid, face, edge or vertex of the arguments; empty: it has vanished.
  std::vector<TopoDS_Shape> piecesOf(const TopoDS_Shape& shape);

 private:
  BOPAlgo_Builder builder_;
};

}  // namespace af2::geometry
