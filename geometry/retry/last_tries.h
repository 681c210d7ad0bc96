// The last remedies for faces that failed, within their edges.
// Not installed.
#pragma once

#include "geometry/retry/remedy.h"

namespace af2::geometry {

/// No quadrilaterals with a reflex corner, which could not be turned round.
bool mayRefuseReflex(const Retrial& retrial, const FaceMeshes& state, std::size_t face);
std::optional<std::size_t> meshWithoutReflex(Retrial& retrial, FaceMeshes& state, std::size_t face);
/// Elements may tilt against the surface by any angle.
bool mayIgnoreNormals(const Retrial& retrial, const FaceMeshes& state, std::size_t face);
/// Rejects a mesh whose elements reach too far.
std::optional<std::size_t> meshIgnoringNormals(Retrial& retrial, FaceMeshes& state,
                                               std::size_t face);
void restoreFailedFace(Retrial& retrial, FaceMeshes& state, const FaceMeshes& next,
                       std::size_t face);

}  // namespace af2::geometry
