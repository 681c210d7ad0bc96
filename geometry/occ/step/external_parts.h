// Finds parts of a STEP assembly that are in separate files.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <string>
#include <vector>

#include "geometry/occ/step/step_document.h"

namespace af2::geometry {

/// The files that an assembly refers to, and whether they were read.
struct ExternalParts {
  std::vector<Handle(XSControl_WorkSession)> sessions;  ///< of those that were read
  std::vector<std::string> read;                        ///< their names in the assembly
  /// Names of files that could not be read and that hold parts which are nowhere else.
  std::vector<std::string> missing;
};

/// session, path  of the file that the document was made of
ExternalParts externalPartsOf(const Handle(XSControl_WorkSession) & session,
                              const std::filesystem::path& path, const StepDocument& document);

}  // namespace af2::geometry
