// Profiles of surfaces of revolution that end nowhere.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <XSControl_WorkSession.hxx>

namespace af2::geometry {

/// A file gives the whole of a curve that is turned about an axis. OpenCASCADE evaluates the
/// surface far out, where the coordinates of a hyperbola are too large for any number, and loses
/// the face. Trims hyperbolas far outside of any model. Call this before the transfer.
void trimEndlessProfiles(const Handle(XSControl_WorkSession) & session);

}  // namespace af2::geometry
