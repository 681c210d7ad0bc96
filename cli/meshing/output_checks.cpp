#include "cli/meshing/output_checks.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "cli/program/usage_error.h"
#include "engine/base/error.h"
#include "geometry/base/words.h"
#include "geometry/io/output_file.h"

namespace af2::cli {

namespace fs = std::filesystem;

std::string extensionsThat(bool geometry::MeshFormat::*holds, const char* conjunction) {
  std::vector<std::string_view> extensions;
  for (const geometry::MeshFormat& format : geometry::meshFormats())
    if (format.*holds) extensions.push_back(format.extension);
  return geometry::listed(extensions, conjunction);
}

namespace {

/// Output files are named on the command line, so that faults in them are usage errors.
template <class Check>
void asUsage(Check check) {
  try {
    check();
  } catch (const InputError& error) {
    throw UsageError(error.what());
  }
}

void checkHolds(const fs::path& output, bool geometry::MeshFormat::*holds, const char* what) {
  if (geometry::meshFormatOf(output).*holds) return;
  throw UsageError(fmt::format("'{}' cannot hold {}; use {}", output.string(), what,
                               extensionsThat(holds, "or")));
}

/// Known before the model is meshed, which may take long.
void checkShows(const fs::path& output, ModelKind kind) {
  if (kind == ModelKind::Planar || !geometry::meshFormatOf(output).isOnlyPlanar) return;
  throw UsageError(
      fmt::format("'{}' can show planar domains only; use .png or .html", output.string()));
}

}  // namespace

void checkOutputs(const MeshRequest& request) {
  std::set<fs::path> seen;
  const auto checkOne = [&](const fs::path& file) {
    std::error_code odd;  // reported when the file is written
    const fs::path place = fs::weakly_canonical(fs::absolute(file), odd);
    if (!odd && !seen.insert(place).second) {
      throw UsageError(fmt::format("'{}' would be written twice", file.string()));
    }
    std::error_code ignored;
    if (fs::equivalent(file, request.model, ignored)) {
      throw UsageError(fmt::format("'{}' would overwrite the model", file.string()));
    }
    asUsage([&] { geometry::checkWritable(file); });
  };
  for (const fs::path& output : request.outputs) {
    asUsage([&] { geometry::meshFormatOf(output); });
    checkShows(output, request.kind());
    if (request.options.order == 2)
      checkHolds(output, &geometry::MeshFormat::holdsSecondOrder, "elements of order 2");
    if (request.fileOptions.lines == geometry::LinesAlong::AllEdges)
      checkHolds(output, &geometry::MeshFormat::holdsLines,
                 "the line elements that --edges asks for");
    checkOne(output);
  }
  const auto holdsGroups = [](const fs::path& file) {
    return geometry::meshFormatOf(file).holdsGroups;
  };
  if (!request.fileOptions.groups.empty() && !request.outputs.empty() &&
      std::ranges::none_of(request.outputs, holdsGroups))
    throw UsageError(fmt::format("--groups is for {} files",
                                 extensionsThat(&geometry::MeshFormat::holdsGroups, "and")));
  const auto isCompressible = [](const fs::path& file) {
    return geometry::meshFormatOf(file).isCompressible;
  };
  if (request.fileOptions.compress && std::ranges::none_of(request.outputs, isCompressible))
    throw UsageError(fmt::format("--compress is for {} files",
                                 extensionsThat(&geometry::MeshFormat::isCompressible, "and")));
  if (!request.report.empty()) checkOne(request.report);
  if (!request.stuckTests.empty()) checkOne(request.stuckTests);
  if (!request.trace.empty()) checkOne(request.trace);
}

}  // namespace af2::cli
