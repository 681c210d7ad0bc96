// A remedy: collapse short edges of the model, near which a face fails, to points.
// Not installed.
#pragma once

#include "geometry/retry/remedy.h"

namespace af2::geometry {

/// Finds the edges that may be collapsed for a face if it failed.
void findShortEdges(Retrial& retrial, const FaceMeshes& state, std::size_t face);
/// Only where shorter edges did not help, or cannot, where their place is unknown, or where they
/// would cost too much. Meshing a face with fewer edges costs little.
bool mayCollapseEdges(const Retrial& retrial, const FaceMeshes& state, std::size_t face);
/// Replaces all earlier requests for the face.
std::optional<std::size_t> collapseEdges(Retrial& retrial, FaceMeshes& state, std::size_t face);
void uncollapseEdges(Retrial& retrial, FaceMeshes& state, const FaceMeshes& next, std::size_t face);

}  // namespace af2::geometry
