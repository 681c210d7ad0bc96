// The tables that `af2 inspect` prints for models of all kinds.
#pragma once

#include <vector>

#include "geometry/edges/edge_entry.h"
#include "geometry/mesh/defect.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::cli {

/// The default mesh size as a fraction of the diagonal.
inline constexpr double kSizesPerDiagonal = 40;

void printGroups(const std::vector<geometry::FaceGroup>& groups);

/// Prints which faces would be meshed together, and without which edges.
void printMerging(const geometry::Merging& merging, double size);

/// Prints which edges belong to which boundary.
void printBoundaries(const std::vector<geometry::EdgeGroup>& boundaries);

/// Prints the id of each edge.
void printEdges(const std::vector<geometry::EdgeEntry>& edges);

/// all  list all defects, not only the first ten of each kind
void printDefects(const std::vector<geometry::Defect>& defects, double size, bool all);

}  // namespace af2::cli
