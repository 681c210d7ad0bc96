// Meshes a surface of triangles by its smooth patches, and checks the mesh.
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
/// 1, 2, ... in the order of their first triangles. New vertices are on the triangles.
///
/// A patch that cannot be meshed whole is cut into pieces whose normals vary less, unless the
/// options name faces or edges: the pieces are faces, too, and a note reports them. A piece that
/// still fails is reported as failed and does not affect the others.
///
/// check  is called with the model before it is meshed, and may throw
///
/// Throws InputError for a size that is not positive.
AF2_EXPORT ModelMesh meshFaceted(const Facets& facets, const AF2Algorithm& algorithm,
                                 const MeshingOptions& options,
                                 const std::function<void(const DomainModel&)>& check = {});

}  // namespace af2::geometry
