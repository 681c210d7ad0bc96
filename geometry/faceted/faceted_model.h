// Patches of triangles as faces between curves.
// Not installed.
#pragma once

#include <array>
#include <cstdint>
#include <map>

#include "geometry/domain/domain_model.h"
#include "geometry/faceted/facet_surface.h"
#include "geometry/faceted/patches.h"

namespace af2::geometry {

/// Details of a twentieth of an edge are invisible; a crease with a loose end must be longer than
/// that. Roundings that are large compared with the model are kept, however large the elements are.
///
/// Throws InputError for a feature angle that is not between 0 and 180 degrees.
FeatureLimits featureLimitsFor(const Facets& facets, const MeshingOptions& options);

/// Faces that were made of patches, by the corners of their first triangles: a patch that comes
/// again is not made again.
struct MadeFaces {
  struct Face {
    FacetSurface surface;
    DomainFace face;
  };
  std::map<std::array<std::uint32_t, 3>, Face> faces;
};

/// made  those of an earlier model, and afterwards those of this one; null: none
DomainModel modelOf(PatchedFacets patched, const MeshingOptions& options,
                    MadeFaces* made = nullptr);

}  // namespace af2::geometry
