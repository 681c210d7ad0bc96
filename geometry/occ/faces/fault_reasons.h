// Says why faces failed, or came out with needles, where the model itself is the cause.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <vector>

#include "geometry/mesh/model_mesh.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// Says of faces that failed, and of those with needles that took more than one attempt, what is
/// wrong with their surface, if that is known: in their reasons, and in the notes of the mesh. A
/// sharp tip, around which all elements are needles, is named, too.
///
/// size  edge length of the mesh
void tellOfSurfaceFaults(const ModelShape& model, double size, ModelMesh& mesh);

/// Says in the reasons of faces that failed which edge each uses in the same direction as another
/// face does: one of the two is turned inside out, or has a loop that is.
void tellOfTurnedEdges(const ModelShape& model, std::vector<FaceReport>& faces);

}  // namespace af2::geometry
