// Joins the meshes of faces at the vertices of their edges.
// Not installed.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "geometry/edges/divided_edges.h"
#include "geometry/mesh/face_mesh.h"

namespace af2::geometry {

struct JoinOptions {
  std::map<int, double> edgeSizes;  ///< by edge, instead of the sizes of its faces
  /// The point of an edge at a parameter. Only for elements of second order; else empty.
  std::function<Point3(int edge, double parameter)> pointOnEdge;
  int threads = 0;
  /// If not null, the vertices inside faces and the elements stay where they are, not in memory;
  /// numbers of elements go to this file.
  std::shared_ptr<SpoolFile> spool = {};
};

/// Vertices are numbered in this order: at model vertices, along edges, inside faces. Vertices that
/// neither an element nor a segment of the boundary uses are left out.
ModelMesh joinFaces(const DividedEdges& divided, const std::vector<FaceMesh>& faces,
                    const JoinOptions& options);

}  // namespace af2::geometry
