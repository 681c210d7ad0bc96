// Finds entities of a STEP file that OpenCASCADE's translator cannot handle.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <XSControl_WorkSession.hxx>
#include <map>
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
/// unusable  the numbers in the file that are not usable (unusableNumbersIn)
StepDamage takeOutDamage(const Handle(XSControl_WorkSession) & session,
                         std::map<int, std::string> unusable);

}  // namespace af2::geometry
