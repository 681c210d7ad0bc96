// A remedy: requests shorter edges around the places at which a face is faulty.
// Not installed.
#pragma once

#include "geometry/retry/remedy.h"

namespace af2::geometry {

/// Finds out whether a face that failed has a fault that shorter edges cannot mend.
void findFault(Retrial& retrial, const FaceMeshes& state, std::size_t face);
bool mayShortenEdges(const Retrial& retrial, const FaceMeshes& state, std::size_t face);
std::optional<std::size_t> shortenEdges(Retrial& retrial, FaceMeshes& state, std::size_t face);
/// Removes all requests of a face that had failed, all places of a face that fails or crosses
/// others now, and else only those of the last round.
void unshortenEdges(Retrial& retrial, FaceMeshes& state, const FaceMeshes& next, std::size_t face);

}  // namespace af2::geometry
