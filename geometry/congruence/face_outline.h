// A face within its divided edges, to be compared with others that may be congruent.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "engine/base/point.h"
#include "geometry/congruence/congruence.h"
#include "geometry/mesh/face_boundary.h"
#include "geometry/mesh/face_history.h"
#include "geometry/sizes/position_size.h"

namespace af2::geometry {

struct FaceOutline {
  BoundaryForm form;
  std::vector<std::uint32_t> points;  ///< as in FaceBoundary
  std::vector<SegmentUse> uses;       ///< as in FaceBoundary
  /// All numbers beside the boundary and the sizes by position on which the mesh depends: equal for
  /// faces whose meshes are the same up to a motion.
  std::vector<double> numbers;
  PositionSize sizes;   ///< by position
  FaceHistory history;  ///< remarks on the boundary
  /// How far a place is from the surface; for one thread. Empty: there is no closed form, and the
  /// surfaces of congruent faces have the same places at the same parameters (`samples`).
  std::function<double(const Point3&)> distance;
  std::vector<Point3> samples;
};

/// Whether a boundary has nothing beside loops and their segments.
inline bool isPlain(const FaceBoundary& boundary) {
  return !boundary.input.loops.empty() && boundary.input.isolated.empty() &&
         boundary.repairs.empty() && boundary.touching.empty() && boundary.fans.empty() &&
         !boundary.layers;
}

}  // namespace af2::geometry
