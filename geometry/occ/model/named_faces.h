// Names for faces of a CAD model, besides those that the file has.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/base/export.h"
#include "geometry/occ/model/model.h"

namespace af2::geometry {

struct NamedFaces {
  std::string name;
  std::vector<int> faces;  ///< ids
};

/// The model with further names. The name of a single face becomes that of the face, in place of
/// the one that it has; a name of several faces becomes a group of them (GroupKind::Part).
///
/// Throws InputError for a name that is empty or has no faces, and for a face that the model does
/// not have.
AF2_EXPORT Model withNames(const Model& model, std::span<const NamedFaces> names);

}  // namespace af2::geometry
