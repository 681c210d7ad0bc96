// The tables that `af2 inspect` prints for models of all kinds.
#pragma once

#include <vector>

#include "geometry/edges/edge_entry.h"
#include "geometry/mesh/defect.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::cli {

/// Of a mesh, if no size is given: this part of the diagonal.
inline constexpr double kSizesPerDiagonal = 40;

void printGroups(const std::vector<geometry::FaceGroup>& groups);

/// Which edges are in which boundary.
void printBoundaries(const std::vector<geometry::EdgeGroup>& boundaries);

/// Which id belongs to which edge.
void printEdges(const std::vector<geometry::EdgeEntry>& edges);

/// all  also those beyond the first ten of each kind
void printDefects(const std::vector<geometry::Defect>& defects, double size, bool all);

}  // namespace af2::cli
