// One face joins the mesh of its model.
#pragma once

#include <algorithm>
#include <vector>

#include "engine/mesh.h"
#include "geometry/model_mesh.h"

namespace af2::geometry {

/// Room for so many more, and no more than that if there was none before.
template <class T>
void makeRoom(std::vector<T>& all, std::size_t more) {
  const std::size_t wanted = all.size() + more;
  if (wanted > all.capacity()) all.reserve(std::max(wanted, all.capacity() + all.capacity() / 2));
}

/// Adds the vertices inside the face and its elements, and counts them in `report`.
///   meshed     what is added goes over piece by piece, so that no face is there twice
///   boundary   the vertices of `mesh` that the first vertices of `meshed` stand for
void appendFace(ModelMesh& mesh, Mesh meshed, const std::vector<VertexId>& boundary,
                FaceReport& report);

}  // namespace af2::geometry
