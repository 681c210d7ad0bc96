#include "cli/meshing/output_scale.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <utility>

#include "cli/program/number_lists.h"
#include "cli/program/usage_error.h"

namespace af2::cli {
namespace {

/// A length in millimetres, multiplied by this, is the length in the unit.
struct Unit {
  const char* name;
  double perMillimetre;
};
constexpr std::array kUnits{Unit{"mm", 1},        Unit{"cm", 1 / 10.},    Unit{"m", 1 / 1000.},
                            Unit{"um", 1000},     Unit{"inch", 1 / 25.4}, Unit{"in", 1 / 25.4},
                            Unit{"ft", 1 / 304.8}};

}  // namespace

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
  const auto* const unit =
      std::ranges::find_if(kUnits, [&](const Unit& known) { return known.name == options.unit; });
  if (unit == kUnits.end())
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
