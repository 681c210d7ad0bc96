// The largest edges that the curvature of patches of triangles allows.
// Not installed.
#pragma once

#include <memory>
#include <vector>

#include "geometry/domain/domain_model.h"
#include "geometry/faceted/facet_surface.h"

namespace af2::geometry {

/// Least size at turns, as a share of the wanted size. It is smaller than on CAD models, where
/// edges along the roundings bring vertices there.
constexpr double kMinAtPatchTurns = 0.2;

/// A patch as a face of a model.
struct PatchFace {
  FacetSurface surface;
  bool isPlane = false;
};

/// The sizes that curvature allows at the vertices of the facets, growing from each along the edges
/// no faster than sizes may.
///
/// knots  by curve: the vertices at its knots; none: it is between planes
CurvatureLimits limitsOfPatches(const Facets& facets, const std::vector<PatchFace>& faces,
                                const std::vector<std::vector<std::uint32_t>>& knots,
                                const DomainSize& size, double growth);

}  // namespace af2::geometry
