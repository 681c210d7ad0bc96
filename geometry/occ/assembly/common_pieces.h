// What two parts have in common, by the general fuse of the two.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include "geometry/mesh/contact.h"
#include "geometry/occ/algorithms/general_fuse.h"
#include "geometry/occ/assembly/model_parts.h"

namespace af2::geometry {

/// What two parts have in common but do not share, without their names. Area, length and volume are
/// 0 if there is nothing.
///
/// Throws GeometryError if the parts cannot be fused.
PartContact contactBetween(const ModelShape& model, const ModelPart& one, const ModelPart& other,
                           const FuseOptions& options);

double volumeOf(const TopoDS_Shape& solid);

}  // namespace af2::geometry
