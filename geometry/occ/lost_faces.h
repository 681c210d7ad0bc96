// Faces of a file that did not come through its reader.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <StepData_StepModel.hxx>
#include <StepShape_Face.hxx>
#include <XSControl_WorkSession.hxx>
#include <string>
#include <vector>

namespace af2::geometry {

/// The number of its entity and its name: "#17 'inlet'".
std::string stepFaceName(const Handle(StepData_StepModel) & model,
                         const Handle(StepShape_Face) & face);

/// The faces of shells that a STEP reader was to transfer and has no shape for, by `stepFaceName`,
/// or as "number 3 of #12" if the file lacks that. To be asked after the transfer.
std::vector<std::string> lostStepFaces(const Handle(XSControl_WorkSession) & session);

/// The same of an IGES reader: faces and surfaces that are faces, by their line in the directory:
/// "D17".
std::vector<std::string> lostIgesFaces(const Handle(XSControl_WorkSession) & session);

}  // namespace af2::geometry
