// Which faces of a model are meshed together, and which edges the mesh crosses for that.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/occ/merge/edge_joints.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// What grouping knows about a model; [0] is face or edge 1.
struct GroupingInput {
  const ModelShape& model;
  const std::vector<EdgeJoint>& joints;
  std::vector<double> areas;    ///< by face
  std::vector<double> lengths;  ///< by edge
  std::vector<double> sizes;    ///< by face: wanted
  std::vector<double> narrow;   ///< by face: how wide a narrow face is at most; 0: none is
  std::vector<double> chords;   ///< by face: bounds on the distance from it; or infinite
  std::vector<bool> mayMerge;   ///< by face
  std::vector<int> part;        ///< by face: faces of different parts stay apart
  std::vector<bool> isKept;     ///< by edge: the user wants to keep it
  double angle = 0;             ///< radians
};

struct FaceGrouping {
  std::vector<std::uint32_t> group;  ///< by face: the first face of its group, counted from 0
  /// By edge: both sides are in one group and meet smoothly, or one of them is narrow.
  std::vector<bool> isInner;
  std::vector<bool> isBesideNarrow;  ///< by edge: it is inner, and the latter is the reason
  std::vector<bool> isNarrow;        ///< by face: merged because it is narrow
  /// By face: it is narrow, also with those that it meets smoothly, and there is no wide face with
  /// which it could be merged. Such faces are meshed one by one.
  std::vector<bool> isAlone;
};

FaceGrouping groupFaces(const GroupingInput& input);

/// The largest angle, in radians, at which elements beside an edge may reach over a vertex or over
/// another edge: less than asked for if a bound on their distance from the model would not hold.
double mostTurnAt(const GroupingInput& input, std::size_t edge);

/// How long a short edge is at most: as wide as a narrow face beside it.
double shortAt(const GroupingInput& input, std::size_t edge);

}  // namespace af2::geometry
