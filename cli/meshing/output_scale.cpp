#include "cli/meshing/output_scale.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "cli/program/number_lists.h"
#include "cli/program/usage_error.h"
#include "geometry/mesh/scaled_mesh.h"

namespace af2::cli {

void declareScale(CLI::App& command, ScaleOptions& options) {
  command
      .add_option("--scale", options.scale,
                  "multiply all coordinates in the files of the mesh by this")
      ->type_name("FACTOR");
  command
      .add_option(
          "--unit", options.unit,
          "unit of the coordinates in the files of the mesh: mm, cm, m, um, inch or ft; for "
          "models that say their unit")
      ->type_name("UNIT");
}

OutputScale checkedScale(const ScaleOptions& options, ModelKind kind) {
  if (!options.scale.empty() && !options.unit.empty())
    throw UsageError("--scale and --unit exclude each other");
  if (!options.scale.empty())
    return {parsePositive("--scale", options.scale, "the factor for coordinates"), ""};
  if (options.unit.empty()) return {};
  const auto units = geometry::lengthUnits();
  const auto unit = std::ranges::find(units, options.unit, &geometry::LengthUnit::name);
  if (unit == units.end())
    throw UsageError(fmt::format("--unit {}: choose one of mm, cm, m, um, inch, ft", options.unit));
  const OutputScale scale{unit->perMillimetre, unit->name};
  if (kind != ModelKind::Cad) checkUnit(scale, "");
  return scale;
}

void checkUnit(const OutputScale& scale, const std::string& unitOfModel) {
  if (!scale.unit.empty() && unitOfModel != "mm")
    throw UsageError(fmt::format(
        "--unit {}: the file of the model does not say its unit; use --scale", scale.unit));
}

}  // namespace af2::cli
