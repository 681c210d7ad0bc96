// A remedy: a face that has failed in spite of all requests gets back its original edges, and so do
// its neighbours.
// Not installed.
#pragma once

#include "geometry/retry/remedy.h"

namespace af2::geometry {

bool hasVainRequests(const Retrial& retrial, const FaceMeshes& state, std::size_t face);
/// Withdraws all requests, so that the next remedies start as if nothing had been tried.
std::optional<std::size_t> withdrawRequests(Retrial& retrial, FaceMeshes& state, std::size_t face);

}  // namespace af2::geometry
