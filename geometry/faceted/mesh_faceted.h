// From a surface of triangles to a checked mesh of its smooth patches.
#pragma once

#include <functional>

#include "engine/base/export.h"
#include "geometry/domain/domain_model.h"
#include "geometry/faceted/facets.h"
#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// The patches between feature edges, as faces between curves.
AF2_EXPORT DomainModel facetedModel(const Facets& facets, const MeshingOptions& options);

/// Meshes each patch between feature edges, which are divided once and shared. Patches are faces:
/// 1, 2, ... in the order of their first triangles. New vertices lie on the triangles.
///
/// A patch that cannot be meshed whole is cut into pieces that turn less, if no faces or edges are
/// named by the options: the pieces are faces, too, and a note tells of them. What fails then is
/// reported as failed and does not spoil the others.
///
/// check  sees the model before it is meshed, and may throw
///
/// Throws InputError for a size that is not positive, or if neighbouring triangles are turned
/// against each other.
AF2_EXPORT ModelMesh meshFaceted(const Facets& facets, const AF2Algorithm& algorithm,
                                 const MeshingOptions& options,
                                 const std::function<void(const DomainModel&)>& check = {});

}  // namespace af2::geometry
