// Says why faces failed, or came out with needles, where the model itself is the cause.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <string>
#include <vector>

#include "geometry/mesh/model_mesh.h"
#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// "in the model itself, ...": what is wrong with the surface of a face or, if it is plane, with
/// its boundary, however the edges are divided. Empty if nothing is found.
///
/// size  edge length of the mesh
std::string faultOf(const ModelShape& model, int face, double size);

/// Says this of faces that failed, in their reasons; and of curved ones with needles that took more
/// than one attempt, in the notes of the mesh. A sharp tip, around which all elements are needles,
/// is named, too.
void tellOfFaults(const ModelShape& model, double size, ModelMesh& mesh);

/// Says in the reasons of faces that failed which edge each uses in the same direction as another
/// face does: one of the two is turned inside out, or has a loop that is.
void tellOfTurnedEdges(const ModelShape& model, std::vector<FaceReport>& faces);

}  // namespace af2::geometry
