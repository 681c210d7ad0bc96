// Parts of a STEP assembly that lie in files of their own.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <STEPCAFControl_Reader.hxx>
#include <string>
#include <vector>

namespace af2::geometry {

/// What became of the files that an assembly refers to.
struct ExternalParts {
  std::vector<Handle(XSControl_WorkSession)> sessions;  ///< of those that were read
  std::vector<std::string> read;                        ///< their names, as the assembly has them
  /// Names of those that could not be read, and that hold parts which lie nowhere else.
  std::vector<std::string> missing;
};

/// To be asked after the transfer to a document, which reads these files.
ExternalParts externalPartsOf(STEPCAFControl_Reader& reader);

}  // namespace af2::geometry
