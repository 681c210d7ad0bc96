// The last remedy for faces that failed: elements may tilt against the surface by any angle.
// Not installed.
#pragma once

#include "geometry/retry/remedy.h"

namespace af2::geometry {

bool mayIgnoreNormals(const Retrial& retrial, const FaceMeshes& state, std::size_t face);
/// Rejects a mesh whose elements reach too far.
std::optional<std::size_t> meshIgnoringNormals(Retrial& retrial, FaceMeshes& state,
                                               std::size_t face);
void restoreFailedFace(Retrial& retrial, FaceMeshes& state, const FaceMeshes& next,
                       std::size_t face);

}  // namespace af2::geometry
