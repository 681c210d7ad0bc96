// Makes parts of a model that touch share their faces, edges and vertices.
#pragma once

#include <stop_token>

#include "engine/base/export.h"
#include "geometry/occ/model/model.h"

namespace af2::geometry {

/// What becomes of the volume that two solids have in common.
enum class Overlaps {
  Refuse,  ///< InputError
  First,   ///< it belongs to the part that comes first in the model
  Last,    ///< it belongs to the part that comes last
  Cut,     ///< it becomes a solid of its own, named "one&other"
};

struct ImprintOptions {
  /// Parts nearer than this touch, in the unit of the model. 0: a ten-millionth of its diagonal.
  double tolerance = 0;
  Overlaps overlaps = Overlaps::Refuse;
  /// Only faces, edges and vertices that are equal as a whole become one. Nothing is intersected,
  /// which is faster.
  bool onlyEqual = false;
  double seconds = 120;  ///< time limit
  std::stop_token stop = {};
};

/// The same model with each of its solids and sheets split where it meets others, and with one
/// face, edge and vertex wherever several met.
///
/// Each face keeps its name, its layers and its colours, and so do the faces that it is split into.
/// A face that two parts share belongs to the groups of both, and to the group "one|other" of kind
/// GroupKind::Interface. Faces and edges are renumbered: parts come in their order in the model,
/// solids before sheets. A shared face looks out of the first of its solids (FaceGroup::inward).
///
/// The result is checked: the volume of each part is kept to a millionth, or to what the tolerance
/// can change, and no solid is open that was closed. If it does not pass, or OpenCASCADE fails or
/// takes too long, the model is returned as it was, with the reason in Model::imprinting. A crash
/// of OpenCASCADE is not caught.
///
/// Throws InputError, with the names of the parts, if solids overlap and Overlaps::Refuse holds; or
/// if the tolerance is negative.
AF2_EXPORT Model imprintModel(const Model& model, const ImprintOptions& options = {});

}  // namespace af2::geometry
