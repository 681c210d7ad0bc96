// A remedy: shorter edges around the places at which a face is at fault.
// Not installed.
#pragma once

#include "geometry/retry/remedy.h"

namespace af2::geometry {

bool mayShortenEdges(const Retrial& retrial, const FaceMeshes& state, std::size_t face);
std::optional<std::size_t> shortenEdges(Retrial& retrial, FaceMeshes& state, std::size_t face);
/// All for a face that had failed; the places of one that fails or crosses others now; else those
/// of the last round.
void unshortenEdges(Retrial& retrial, FaceMeshes& state, const FaceMeshes& next, std::size_t face);

}  // namespace af2::geometry
