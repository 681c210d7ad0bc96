// Faces that are the rest of what they should be, told by what passes through them.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// A face between two poles bounds as much of its surface as its rest does (turned_faces.h), and a
/// file may hold the wrong one of them: then other faces of the same closed shell pass through it,
/// and none through the rest. Puts the rest in its place, turns the shell to look outwards, and
/// tells of it.
void turnBackCrossedFaces(ReadShape& read);

}  // namespace af2::geometry
