// Entities of a STEP file that OpenCASCADE's translator would better not meet.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <XSControl_WorkSession.hxx>
#include <filesystem>
#include <string>
#include <vector>

#include "geometry/occ/read/lost_faces.h"

namespace af2::geometry {

struct StepDamage {
  std::string text;              ///< which entities are damaged and how; empty if none
  std::vector<TakenFace> faces;  ///< taken out of their shells
};

/// Entities that refer to what the file does not hold, or have values that are no numbers or larger
/// than any length can be. The translator crashes on them, does not come to an end, or takes
/// whatever lay in memory for a value. Faces that depend on such an entity are taken out of the
/// model. To be asked before the transfer.
///
/// path  the file that the session has read
StepDamage takeOutDamage(const Handle(XSControl_WorkSession) & session,
                         const std::filesystem::path& path);

}  // namespace af2::geometry
