// Finds the defects of a model, and their extent compared with the size of a mesh.
#pragma once

#include <vector>

#include "engine/base/export.h"
#include "geometry/mesh/defect.h"
#include "geometry/occ/model/model.h"

namespace af2::geometry {

/// All defects of a model, by kind; tiny edges, slivers, gaps and open loops from the most to the
/// least severe, others in the order of the model. Gaps below a ten-thousandth of the mesh size do
/// not count.
///
/// size  edge length of a mesh, > 0
AF2_EXPORT std::vector<Defect> findDefects(const Model& model, double size);

/// Points along an edge of the model, dense enough to draw it; empty if it has no length.
AF2_EXPORT std::vector<Point3> pointsAlong(const Model& model, int edge);
/// The edges around a face, each once.
AF2_EXPORT std::vector<int> edgesAround(const Model& model, int face);

}  // namespace af2::geometry
