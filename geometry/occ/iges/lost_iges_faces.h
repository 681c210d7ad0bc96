// Finds faces of an IGES file that its reader lost.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <XSControl_WorkSession.hxx>
#include <string>
#include <vector>

namespace af2::geometry {

/// The faces, and surfaces that are faces, for which an IGES reader has made no shape, by their
/// line in the directory: "D17". Call this after the transfer.
std::vector<std::string> lostIgesFaces(const Handle(XSControl_WorkSession) & session);

}  // namespace af2::geometry
