// The last remedy for faces that failed: elements that lean against the surface as far as they
// like. Not installed.
#pragma once

#include "geometry/retry/remedy.h"

namespace af2::geometry {

bool mayIgnoreNormals(const Retrial& retrial, const FaceMeshes& state, std::size_t face);
/// A mesh whose elements reach too far is of no use.
std::optional<std::size_t> meshIgnoringNormals(Retrial& retrial, FaceMeshes& state,
                                               std::size_t face);
void restoreFailedFace(Retrial& retrial, FaceMeshes& state, const FaceMeshes& next,
                       std::size_t face);

}  // namespace af2::geometry
