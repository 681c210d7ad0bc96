#include "cli/meshing/periodic_request.h"

#include <fmt/core.h>

#include "cli/program/number_lists.h"
#include "cli/program/usage_error.h"

namespace af2::cli {

void declarePeriodic(CLI::App& command, PeriodicOptions& options) {
  command
      .add_option("--periodic", options.asked,
                  "make the mesh of a face the image of that of another: x, y or z for the plane "
                  "faces at both sides of a CAD model, or numbers or names of two faces, e.g. 3=5 "
                  "or inlet=outlet")
      ->type_name("PAIR")
      ->take_all()
      ->expected(1);
}

namespace {

PeriodicFace oneFace(const std::string& option, const std::string& text) {
  const FaceList faces = parseFaces("--periodic", text);
  if (faces.ids.size() + faces.names.size() != 1)
    throw UsageError(fmt::format("--periodic '{}': give one face on each side of '='", option));
  return faces.names.empty() ? PeriodicFace{faces.ids.front()}
                             : PeriodicFace{0, faces.names.front()};
}

}  // namespace

PeriodicFaces checkedPeriodic(const PeriodicOptions& options, ModelKind kind) {
  PeriodicFaces faces;
  if (!options.asked.empty() && kind != ModelKind::Cad)
    throw UsageError("--periodic is for " + formatNames(ModelKind::Cad, "and") + " files");
  for (const std::string& text : options.asked) {
    if (text == "x" || text == "y" || text == "z") {
      faces.directions.push_back(text);
      continue;
    }
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
      throw UsageError(fmt::format(
          "--periodic '{}': write x, y, z, or the ids of two faces, such as 3=5, or their names",
          text));
    faces.pairs.emplace_back(oneFace(text, text.substr(0, equals)),
                             oneFace(text, text.substr(equals + 1)));
  }
  return faces;
}

}  // namespace af2::cli
