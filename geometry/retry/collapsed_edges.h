// A remedy: short edges of the model, near which a face fails, become points.
// Not installed.
#pragma once

#include "geometry/retry/remedy.h"

namespace af2::geometry {

/// The choices that the model leaves for the faces that failed.
void findShortEdges(Retrial& retrial, const FaceMeshes& state);
/// Only where shorter edges did not help, or nobody knows where they should be, or they would cost
/// too much. To mesh a face with fewer edges costs little.
bool mayCollapseEdges(const Retrial& retrial, const FaceMeshes& state, std::size_t face);
/// Instead of all that was asked for before.
std::optional<std::size_t> collapseEdges(Retrial& retrial, FaceMeshes& state, std::size_t face);
void uncollapseEdges(Retrial& retrial, FaceMeshes& state, const FaceMeshes& next, std::size_t face);

}  // namespace af2::geometry
