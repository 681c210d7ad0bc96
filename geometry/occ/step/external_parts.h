// Finds parts of a STEP assembly that are in separate files.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <STEPCAFControl_Reader.hxx>
#include <string>
#include <vector>

namespace af2::geometry {

/// The files that an assembly refers to, and whether they were read.
struct ExternalParts {
  std::vector<Handle(XSControl_WorkSession)> sessions;  ///< of those that were read
  std::vector<std::string> read;                        ///< their names in the assembly
  /// Names of files that could not be read and that hold parts which are nowhere else.
  std::vector<std::string> missing;
};

/// Call this after the transfer to a document, which reads these files.
ExternalParts externalPartsOf(STEPCAFControl_Reader& reader);

}  // namespace af2::geometry
