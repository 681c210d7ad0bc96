// Replaces the mesh of a face by the image of that of another.
// Not installed.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/mesh/model_mesh.h"

namespace af2::geometry {

/// In ascending order.
std::vector<std::size_t> elementsOfFace(const ModelMesh& mesh, int face);

/// Makes the elements of pair.second images of those of pair.first. Vertices on edges of the second
/// face move to the images, by no more than `tolerance`. Fills pair.vertices. Returns why that is
/// not possible, and then leaves the mesh as it is; empty: it was done.
std::string makeImage(ModelMesh& mesh, PeriodicPair& pair, double tolerance);

}  // namespace af2::geometry
