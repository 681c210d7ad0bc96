#include "cli/meshing/imprint_request.h"

#include <CLI/CLI.hpp>

#include "cli/program/number_lists.h"
#include "cli/program/usage_error.h"

namespace af2::cli {

void declareImprint(CLI::App& command, ImprintFlags& flags) {
  command.add_flag("--imprint", flags.imprint,
                   "make solids and sheets of a CAD model that touch share faces, edges and "
                   "vertices there, so that their meshes match");
  command.add_flag("--glue", flags.glue,
                   "like --imprint, but only for faces, edges and vertices that are equal as a "
                   "whole; faster, because nothing is intersected");
  command
      .add_option(
          "--imprint-tolerance", flags.tolerance,
          "with --imprint or --glue: parts nearer than this touch; default: a ten-millionth "
          "of the diagonal")
      ->type_name("SIZE");
  command
      .add_option("--overlap", flags.overlap,
                  "with --imprint: first, last or cut: the volume that two solids have in common "
                  "belongs to the first one, to the last one, or becomes a solid of its own; "
                  "without this option, solids that overlap are refused")
      ->type_name("PART")
      ->check(CLI::IsMember({"first", "last", "cut"}).description(""));
}

ImprintRequest checkedImprint(const ImprintFlags& flags, ModelKind kind) {
  ImprintRequest request;
  request.isAsked = flags.imprint || flags.glue;
  if (!request.isAsked) {
    if (!flags.tolerance.empty()) throw UsageError("--imprint-tolerance needs --imprint or --glue");
    if (!flags.overlap.empty()) throw UsageError("--overlap needs --imprint");
    return request;
  }
  const char* name = flags.imprint ? "--imprint" : "--glue";
  if (kind != ModelKind::Cad) {
    const std::string formats = formatNames(ModelKind::Cad, "and");
    throw UsageError(std::string(name) + " is for " + (formats.empty() ? "CAD" : formats) +
                     " files");
  }
  if (flags.imprint && flags.glue)
    throw UsageError(
        "--imprint and --glue exclude each other; --imprint does all that --glue does");
  if (flags.glue && !flags.overlap.empty())
    throw UsageError("--overlap needs --imprint; --glue does not look for overlaps");
  request.onlyEqual = flags.glue;
  request.overlap = flags.overlap;
  if (!flags.tolerance.empty())
    request.tolerance = parseSize("--imprint-tolerance", flags.tolerance);
  return request;
}

}  // namespace af2::cli
