// How smoothly faces meet along the edges of a model.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <limits>
#include <vector>

#include "engine/base/point.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// Two faces, or both sides of the seam of one, that meet along an edge.
struct EdgeJoint {
  int one = 0, other = 0;  ///< ids; 0: the edge is free, has several sheets, or has no length
  /// The largest angle between their normals along the edge, in radians; infinite: not known.
  double angle = std::numeric_limits<double>::infinity();
  /// By how much the curvature across the edge differs from one side to the other: 0 where an edge
  /// divides a surface, the inverse of the radius where a rounding begins. Along a tube, which
  /// bends as much along its edges, it is 0.
  double bend = 0;
  /// The outward normals of both faces halfway along the edge; 0: not known.
  Point3 normalOfOne{}, normalOfOther{};

  bool isJoint() const { return one > 0; }
  bool isSeam() const { return one == other; }
};

/// By edge; [0] is edge 1.
std::vector<EdgeJoint> jointsOf(const ModelShape& model, int threads);

}  // namespace af2::geometry
