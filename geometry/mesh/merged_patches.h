// Which faces of a mesh were meshed together: their elements cross the edges between them.
// Not installed.
#pragma once

#include <map>

#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

class MergedPatches {
 public:
  explicit MergedPatches(const ModelMesh& mesh) {
    if (!mesh.merging) return;
    for (const MergedGroup& group : mesh.merging->groups)
      for (const int face : group.faces) firstOf_[face] = group.faces.front();
  }

  /// The first of the faces that were meshed together with a face, or this face itself.
  int of(int face) const {
    if (firstOf_.empty()) return face;
    const auto found = firstOf_.find(face);
    return found == firstOf_.end() ? face : found->second;
  }

 private:
  std::map<int, int> firstOf_;
};

}  // namespace af2::geometry
