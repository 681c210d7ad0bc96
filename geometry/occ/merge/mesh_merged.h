// Meshes of CAD models across edges that only the CAD has.
#pragma once

#include "engine/base/export.h"
#include "geometry/occ/merge/merge_request.h"
#include "geometry/occ/run/mesh_model.h"

namespace af2::geometry {

/// As meshModel, but faces that meet smoothly are meshed together, without edges and vertices of
/// the model inside. Vertices are on the CAD surfaces, and each element is of the face under its
/// middle. ModelMesh::merging lists what was merged. Faces with layers are meshed one by one, and
/// so are those whose common mesh fails, with the reason in that list.
///
/// Throws InputError also for an angle that is not between 0 and 60 degrees, a share that is not
/// between 0 and 0.5, an edge that the model does not have, a name that no face has, and for
/// MeshingOptions::fewest.
AF2_EXPORT ModelMesh meshMerged(const Model& model, const AF2Algorithm& algorithm,
                                const MeshingOptions& options, const MergeRequest& request,
                                const TurnLimits& turns = {});

/// What meshMerged would merge at these sizes, without a mesh: no deviations.
AF2_EXPORT Merging mergingOf(const Model& model, const MeshingOptions& options,
                             const MergeRequest& request, const TurnLimits& turns = {});

}  // namespace af2::geometry
