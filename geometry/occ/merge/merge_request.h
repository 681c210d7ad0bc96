// What is asked of meshes that cross edges of a CAD model.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace af2::geometry {

/// Which edges of a CAD model a mesh may cross, so that faces are meshed together.
struct MergeRequest {
  /// Degrees. Faces that meet along an edge by no more than this angle, anywhere along it, are
  /// merged; edges that meet at a vertex by no more than this angle are divided as one, if the
  /// vertex has no other edge that the mesh follows.
  double angle = 10;
  /// Share of the wanted size. A face that is narrower is merged with the neighbour with which it
  /// shares most of its boundary, at any angle, if elements come no farther from it than half this
  /// share. Vertices of edges that are shorter are left out. 0: neither.
  double narrow = 0.2;
  std::set<int> keptEdges = {};  ///< ids: the mesh follows these edges in any case
  /// Names of faces and groups, with `*` and `?`: edges between such faces and others are kept.
  std::vector<std::string> keptAround = {};
};

}  // namespace af2::geometry
