// Replaces faces that were read as the rest of their surface, and so are crossed by others.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include "geometry/occ/model/model_shape.h"

namespace af2::geometry {

/// The boundary of a face between two poles fits both the face and the rest of its surface
/// (turned_faces.h), and a file may contain the wrong one of them: then other faces of the same
/// closed shell pass through it, and none through the rest. Replaces the face by the rest, orients
/// the shell outwards, and adds a note.
void turnBackCrossedFaces(ReadShape& read);

}  // namespace af2::geometry
