// Patches of triangles as faces between curves.
// Not installed.
#pragma once

#include "geometry/domain/domain_model.h"
#include "geometry/faceted/patches.h"

namespace af2::geometry {

/// Details of a twentieth of an edge are invisible; a crease with a loose end must be longer than
/// that. Roundings that are large compared with the model are kept, however large the elements are.
///
/// Throws InputError for a feature angle that is not between 0 and 180 degrees.
FeatureLimits featureLimitsFor(const Facets& facets, const MeshingOptions& options);

DomainModel modelOf(PatchedFacets patched, const MeshingOptions& options);

}  // namespace af2::geometry
