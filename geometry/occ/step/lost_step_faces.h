// Finds faces of a STEP file that its reader lost.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <StepData_StepModel.hxx>
#include <StepShape_ConnectedFaceSet.hxx>
#include <StepShape_Face.hxx>
#include <XSControl_WorkSession.hxx>
#include <string>
#include <vector>

namespace af2::geometry {

/// A face that a shell of a STEP file had before the transfer.
struct TakenFace {
  Handle(StepShape_ConnectedFaceSet) shell;
  std::string name;  ///< as `stepFaceName`, with the fault in brackets
};

/// The number of its entity and its name, "#17 'inlet'"; or "number 3 of #12" if the file lacks it.
///
/// number  of the face in the shell, from 1
std::string stepFaceName(const Handle(StepData_StepModel) & model,
                         const Handle(StepShape_ConnectedFaceSet) & shell, int number);

/// The names of the faces of shells for which a STEP reader has made no shape. Call this after the
/// transfer.
///
/// taken  faces that were removed from shells before the transfer
std::vector<std::string> lostStepFaces(const Handle(XSControl_WorkSession) & session,
                                       const std::vector<TakenFace>& taken);

}  // namespace af2::geometry
