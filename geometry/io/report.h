// Writes the report of a run as JSON (docs/formats.md explains each field).
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "engine/base/export.h"
#include "geometry/mesh/model_mesh.h"
#include "geometry/mesh/quality.h"

namespace af2::geometry {

class OutputFile;

enum class RunStatus {
  Complete,   ///< every face asked for is meshed, and the mesh passed all checks
  Partial,    ///< some faces failed; the mesh of the others is there
  Failed,     ///< there is no mesh
  Cancelled,  ///< stopped from outside; the mesh so far is there
};

AF2_EXPORT const char* toString(RunStatus status);
AF2_EXPORT const char* toString(FaceStatus status);
/// "model" or "size"; empty if it is not known.
AF2_EXPORT const char* toString(FailureCause cause);

/// The status of a run, from the statuses of its faces; Failed if there are none.
AF2_EXPORT RunStatus statusOf(const ModelMesh& mesh);

struct RunReport {
  RunStatus status = RunStatus::Failed;
  std::string reason;  ///< of failure; empty: not written
  MeshQuality quality;
  /// Further fields by name, each with a value in JSON.
  std::map<std::string, std::string> sections = {};
};

AF2_EXPORT void writeReport(const RunReport& report, const ModelMesh& mesh, OutputFile& file);
/// The same to the file at `path`, completely or not at all. Throws InputError if it cannot be
/// written.
AF2_EXPORT void writeReport(const RunReport& report, const ModelMesh& mesh,
                            const std::filesystem::path& path);

}  // namespace af2::geometry
