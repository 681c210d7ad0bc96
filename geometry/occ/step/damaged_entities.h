// Finds entities of a STEP file that OpenCASCADE's translator cannot handle.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <XSControl_WorkSession.hxx>
#include <filesystem>
#include <string>
#include <vector>

#include "geometry/occ/step/lost_step_faces.h"

namespace af2::geometry {

struct StepDamage {
  std::string text;              ///< which entities are damaged and how; empty if none
  std::vector<TakenFace> faces;  ///< removed from their shells
};

/// Finds entities that refer to missing entities, or have values that are not numbers or larger
/// than any length can be. The translator crashes on them, does not end, or uses uninitialised
/// memory. Faces that depend on such an entity are removed from the model. Call this before the
/// transfer.
///
/// path  the file that the session has read
StepDamage takeOutDamage(const Handle(XSControl_WorkSession) & session,
                         const std::filesystem::path& path);

}  // namespace af2::geometry
