// The pieces of the model's edges that the segments of a mesh stand for.
// Not installed.
#pragma once

#include <functional>
#include <vector>

#include "geometry/edges/divided_edges.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// By segment: points of its edge between its ends, in order.
using EdgeCurves = std::vector<std::vector<Point3>>;

/// pointOnEdge  by number of the divided edge, which the segments of the mesh still name
EdgeCurves edgeCurves(const ModelMesh& mesh, const DividedEdges& divided,
                      const std::function<Point3(int edge, double parameter)>& pointOnEdge);

}  // namespace af2::geometry
