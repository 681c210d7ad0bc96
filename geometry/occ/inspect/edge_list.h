// The edges of a model as a table of ids and properties.
#pragma once

#include <vector>

#include "engine/base/export.h"
#include "geometry/edges/edge_entry.h"
#include "geometry/occ/model/model.h"

namespace af2::geometry {

/// All edges by their ids, except those without length or curve.
AF2_EXPORT std::vector<EdgeEntry> edgesOf(const Model& model);

}  // namespace af2::geometry
