// Meshes a planar domain and checks the mesh, without a CAD kernel.
#pragma once

#include "engine/base/export.h"
#include "geometry/domain/domain_model.h"
#include "geometry/mesh/model_mesh.h"
#include "geometry/planar/poly_file.h"

namespace af2::geometry {

/// The regions that the segments bound, as faces between curves.
AF2_EXPORT DomainModel planarModel(const PlanarDomain& domain, const MeshingOptions& options);

/// Meshes the regions that the segments bound, except the outside and the regions of hole points.
/// Each connected region is a face: 1, 2, ... in the order of its lowest, then leftmost vertex.
/// Segments inside a region are kept as edges of the mesh.
///
/// Throws InputError if segments cross, if they enclose nothing, or if a size is not positive.
AF2_EXPORT ModelMesh meshPlanar(const PlanarDomain& domain, const AF2Algorithm& algorithm,
                                const MeshingOptions& options);

}  // namespace af2::geometry
