// Finds details of a planar domain or a surface of triangles that are difficult at a mesh size.
#pragma once

#include <vector>

#include "engine/base/export.h"
#include "geometry/domain/domain_model.h"
#include "geometry/mesh/defect.h"

namespace af2::geometry {

/// Tiny edges and slivers, from the most to the least severe; for a surface of triangles also edges
/// with one face or with more than two, in the order of the model.
///
/// size  edge length of a mesh, > 0
AF2_EXPORT std::vector<Defect> findDefects(const DomainModel& model, double size);

}  // namespace af2::geometry
