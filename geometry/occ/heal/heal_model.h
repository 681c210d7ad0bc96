// Repairs a model where its parts do not fit together, and tells all that it changed.
#pragma once

#include "engine/base/export.h"
#include "geometry/occ/model/model.h"

namespace af2::geometry {

struct HealingOptions {
  /// How far edges may lie apart that are to be one, and how long an edge is that may go, in the
  /// unit of the model. 0: a hundred-thousandth of the diagonal.
  double tolerance = 0;
};

/// The same model with
///   * loops that lack an edge closed: with that of a face beside, or with a straight new one;
///   * the edges of its wires in order, connected, and without gaps; missing curves, seams and
///     degenerated edges added; wires that run the wrong way round turned;
///   * edges and faces smaller than the tolerance taken out;
///   * faces that do not share edges sewn, those of each solid, and all that belong to no solid;
///   * the faces of each shell turned to the same side, those of solids outwards.
/// Model::healing() tells all of it. Faces and edges are numbered anew; names and groups stay with
/// their faces. Repairs that are sound can still leave a face that cannot be meshed: mesh both
/// models and let sounderMesh choose.
///
/// Runs OpenCASCADE's repairs, which can crash or hang on damaged models. Throws InputError if the
/// tolerance is negative or nothing is left of the model.
AF2_EXPORT Model healModel(const Model& model, const HealingOptions& options = {});

}  // namespace af2::geometry
