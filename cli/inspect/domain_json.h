// `af2 inspect --json` for planar domains and surfaces of triangles.
#pragma once

#include <string>
#include <vector>

#include "geometry/domain/domain_model.h"
#include "geometry/edges/edge_entry.h"

namespace af2::cli {

/// The ids of the edges around a face, ascending.
std::vector<int> edgesOfFace(const geometry::DomainFace& face, const geometry::DomainModel& model);

/// By id. Where other edges split an edge of the file, its parts keep its number.
std::vector<geometry::EdgeEntry> edgesOf(const geometry::DomainModel& model);

/// Faces, edges, groups and boundaries with their measures.
std::string domainJson(const geometry::DomainModel& model);

}  // namespace af2::cli
