// Names, colours and layers that a STEP file gives to parts and their pieces.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include "geometry/occ/step/step_entities.h"
#include "geometry/occ/step/step_parts.h"

namespace af2::geometry {

class StepAttributes {
 public:
  StepAttributes(const Handle(XSControl_WorkSession) & session, StepParts& parts)
      : session_(session), entities_(session), parts_(parts) {}

  /// Call this when all parts are there.
  void read();

 private:
  void readColors();
  void readNames();
  void readLayers();

  Handle(XSControl_WorkSession) session_;
  StepEntities entities_;
  StepParts& parts_;
};

}  // namespace af2::geometry
