// A remedy: a face that has failed whatever was asked for its sake gets back the edges that it had
// at the beginning, and so do those beside it.
// Not installed.
#pragma once

#include "geometry/retry/remedy.h"

namespace af2::geometry {

bool hasVainRequests(const Retrial& retrial, const FaceMeshes& state, std::size_t face);
/// So that what comes after begins as if nothing had been tried.
std::optional<std::size_t> withdrawRequests(Retrial& retrial, FaceMeshes& state, std::size_t face);

}  // namespace af2::geometry
