// Repairs a model where its parts do not fit together, and reports all changes.
#pragma once

#include "engine/base/export.h"
#include "geometry/occ/model/model.h"

namespace af2::geometry {

struct HealingOptions {
  /// Maximum distance of edges that are merged, and maximum length of edges that are removed, in
  /// the unit of the model. 0: a hundred-thousandth of the diagonal.
  double tolerance = 0;
};

/// The same model with
///   * loops that lack an edge closed: with the edge of an adjacent face, or a new straight one;
///   * the edges of its wires in order, connected, and without gaps; missing curves, seams and
///     degenerated edges added; wires with the wrong direction reversed;
///   * edges and faces smaller than the tolerance removed;
///   * faces that do not share edges sewn, those of each solid, and all that belong to no solid;
///   * the faces of each shell oriented alike, those of solids outwards.
/// Model::healing() reports all changes. Faces and edges are renumbered; names and groups stay with
/// their faces. Valid repairs can still leave a face that cannot be meshed: mesh both models and
/// let sounderMesh choose.
///
/// Runs OpenCASCADE's repairs, which can crash or hang on damaged models. Throws InputError if the
/// tolerance is negative or nothing is left of the model.
AF2_EXPORT Model healModel(const Model& model, const HealingOptions& options = {});

}  // namespace af2::geometry
