// The plan of a mesh that crosses edges of its model.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <stop_token>
#include <string>
#include <vector>

#include "geometry/occ/merge/edge_joints.h"
#include "geometry/occ/merge/merge_request.h"
#include "geometry/occ/merge/quilt_loops.h"
#include "geometry/occ/merge/quilt_surface.h"
#include "geometry/occ/sizes/cad_sizes.h"

namespace af2::geometry {

/// Faces that are meshed together, or a face that is meshed like that because edges around it are
/// divided as one.
struct Quilt {
  std::shared_ptr<const QuiltParts> parts;  ///< the first of its faces stands for all
  QuiltLoops boundary;
  double area = 0;
};

struct MergePlan {
  std::vector<Quilt> quilts;
  std::map<int, std::size_t> quiltOf;  ///< by face
  MergedEdges edges;
  std::vector<int> besideNarrow;    ///< edges that are not followed because a face is narrow
  std::vector<int> vertices;        ///< that no mesh has, ascending
  std::map<int, std::string> kept;  ///< by face: why it was not merged although it could be
};

struct PlanInput {
  std::shared_ptr<const ModelShape> model;
  const MergeRequest& request;
  const Sizes& sizes;
  const std::vector<EdgeJoint>& joints;
  const std::vector<double>& lengths;  ///< by edge, [0] is edge 1
  std::vector<double> areas;           ///< by face, [0] is face 1
  std::vector<bool> mayMerge;          ///< by face
  std::set<int> keptEdges;             ///< in addition to those of the request
  std::map<int, std::string> givenUp;  ///< faces not to be merged, and why
  std::map<int, int> part;             ///< by face: faces of different parts stay apart; or 0
  std::stop_token stop;
};

MergePlan planMerging(PlanInput input);

/// About half of a group by area: faces that are connected across edges which the mesh crosses.
std::vector<int> halfOf(const std::vector<int>& group, const std::vector<double>& areas,
                        const std::vector<EdgeJoint>& joints, const std::vector<bool>& isInner);

}  // namespace af2::geometry
