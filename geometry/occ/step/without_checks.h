// Leaves out OpenCASCADE's checks of the entities of STEP files.
// Not installed: includers need OpenCASCADE's headers.
#pragma once

#include <Interface_GeneralModule.hxx>

namespace af2::geometry {

/// As long as it lives, entities that have been read are not checked for how others refer to them.
/// Whoever asks for messages gets to know that an edge is not used twice, after up to a sixth of
/// the time of reading (docs/performance.md); what becomes of a shape does not depend on it.
/// Entities that cannot be read are still told. Construct it after the reader, which sets what is
/// replaced here and put back at the end.
class WithoutChecks {
 public:
  WithoutChecks();
  WithoutChecks(const WithoutChecks&) = delete;
  WithoutChecks& operator=(const WithoutChecks&) = delete;
  ~WithoutChecks();

 private:
  Handle(Interface_GeneralModule) before_;  ///< null: nothing was replaced
};

}  // namespace af2::geometry
