#include "cli/meshing/stream_request.h"

#include <fmt/core.h>

#include <algorithm>

#include "cli/meshing/output_checks.h"
#include "cli/program/usage_error.h"

namespace af2::cli {
namespace {

namespace fs = std::filesystem;

/// Empty: nothing.
std::string whatSpeaksAgainst(const MeshRequest& request) {
  using geometry::MeshFormat;
  const auto inMemory = std::ranges::find_if(request.outputs, [](const fs::path& output) {
    return !geometry::meshFormatOf(output).holdsSpooled;
  });
  if (inMemory != request.outputs.end())
    return fmt::format("--stream: '{}' needs the whole mesh in memory; use {}", inMemory->string(),
                       extensionsThat(&MeshFormat::holdsSpooled, "or"));
  const geometry::Sizes& sizes = request.options.sizes;
  const char* with = request.options.order != 1    ? "--order 2"
                     : sizes.chords.areGiven()     ? "bounds on the distance from the model"
                     : sizes.elementsAcross > 0    ? "--elements-across"
                     : request.periodic.areAsked() ? "--periodic"
                     : request.merge.isAsked       ? "--merge"
                     : request.statistics          ? "--statistics"
                                                   : nullptr;
  return with ? fmt::format("--stream cannot be combined with {}", with) : "";
}

fs::path folderOf(const MeshRequest& request) {
  if (!request.outputs.empty()) return request.outputs.front().parent_path();
  return request.report.parent_path();
}

}  // namespace

geometry::SpoolRequest checkedStream(bool isAsked, const MeshRequest& request) {
  using When = geometry::SpoolRequest::When;
  const std::string fault = whatSpeaksAgainst(request);
  if (isAsked && !fault.empty()) throw UsageError(fault);
  const When when = isAsked ? When::Always : fault.empty() ? When::IfNeeded : When::Never;
  return {when, folderOf(request)};
}

}  // namespace af2::cli
