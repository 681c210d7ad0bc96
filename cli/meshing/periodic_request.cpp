#include "cli/meshing/periodic_request.h"

#include <fmt/core.h>

#include "cli/program/number_lists.h"
#include "cli/program/usage_error.h"

namespace af2::cli {

void declarePeriodic(CLI::App& command, PeriodicOptions& options) {
  command
      .add_option("--periodic", options.asked,
                  "make the mesh of a face the image of that of another: x, y or z for the plane "
                  "faces at both sides of a CAD model, or ids of two faces, e.g. 3=5")
      ->type_name("PAIR")
      ->take_all()
      ->expected(1);
}

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
          "--periodic '{}': write x, y, z, or the ids of two faces, such as 3=5", text));
    const std::vector<int> first = parseIds("--periodic", text.substr(0, equals));
    const std::vector<int> second = parseIds("--periodic", text.substr(equals + 1));
    if (first.size() != 1 || second.size() != 1)
      throw UsageError(fmt::format("--periodic '{}': give one face on each side of '='", text));
    faces.pairs.emplace_back(first.front(), second.front());
  }
  return faces;
}

}  // namespace af2::cli
