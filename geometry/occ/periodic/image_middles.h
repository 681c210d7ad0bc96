// Middles of the sides of elements of second order on periodic faces.
// Not installed.
#pragma once

#include <utility>
#include <vector>

#include "geometry/mesh/face_mesh.h"
#include "geometry/mesh/model_mesh.h"
#include "geometry/mesh/second_order.h"

namespace af2::geometry {

/// The middles of a mesh, by element, grouped by face.
MiddlesByFace groupedByFace(const ModelMesh& mesh, const std::vector<SideMiddles>& middles);

/// The middles of pair.second, and those of the segments on its edges, become the images of those
/// of pair.first. For meshes of first order after makeImage.
void makeImagesOfMiddles(ModelMesh& mesh, const PeriodicPair& pair, MiddlesByFace& middles);

/// The sides of the first faces of all pairs, each with its image.
std::vector<std::pair<SideEnds, SideEnds>> imagesOfSides(const ModelMesh& mesh);

/// Adds the midside vertices to PeriodicPair::vertices.
void addMidsides(ModelMesh& mesh);

}  // namespace af2::geometry
