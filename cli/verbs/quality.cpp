// af2 quality
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/meshing/measures_text.h"
#include "cli/program/exit_code.h"
#include "cli/program/number_lists.h"
#include "cli/program/usage_error.h"
#include "cli/program/verbs.h"
#include "engine/base/error.h"
#include "geometry/base/file_extension.h"
#include "geometry/io/mesh_files.h"
#include "geometry/io/output_file.h"
#include "geometry/reading/read_mesh.h"

namespace af2::cli {
namespace {

/// A file without faces has edges where the surface turns by more than this.
constexpr double kDefaultFeatureDegrees = 40;

struct QualityOptions {
  std::string mesh, size, featureAngle, picture, format = "pretty";
};

void checkPicture(const std::string& file) {
  if (file.empty()) return;
  const std::string extension = geometry::extensionOf(file);
  if (extension != ".png" && extension != ".svg" && extension != ".html")
    throw UsageError("--picture " + file + ": give a file that ends in .png, .svg or .html");
  try {
    geometry::checkWritable(file);
  } catch (const InputError& error) {
    throw UsageError(error.what());
  }
}

geometry::MeasureOptions measureOptions(const QualityOptions& options, bool hasFaces) {
  geometry::MeasureOptions result;
  if (!options.size.empty()) result.size = parseSize("--size", options.size);
  if (!hasFaces) result.featureDegrees = kDefaultFeatureDegrees;
  if (options.featureAngle.empty()) return result;
  result.featureDegrees =
      parsePositive("--feature-angle", options.featureAngle, "the angle in degrees");
  if (result.featureDegrees > 180)
    throw UsageError(fmt::format("--feature-angle {}: give an angle of at most 180 degrees",
                                 options.featureAngle));
  return result;
}

/// What the file does not say, and what is done instead.
void addNotes(const QualityOptions& options, geometry::MeshFile& file) {
  geometry::ModelMesh& mesh = file.mesh;
  if (!file.hasFaces && options.featureAngle.empty())
    mesh.notes.push_back(fmt::format(
        "the file has no faces; edges at which the surface turns by more than {} degrees are taken "
        "for boundaries (--feature-angle)",
        kDefaultFeatureDegrees));
  if (mesh.wantedSizes.empty() && options.size.empty())
    mesh.notes.push_back(
        "the file has no target sizes; edge lengths are divided by their median (--size gives a "
        "size)");
}

/// Boundaries are drawn as edges of the model are.
void drawPicture(const std::string& picture, const geometry::MeasureOptions& measure,
                 geometry::ModelMesh mesh) {
  const auto boundaries = geometry::boundaryEdges(mesh, measure);
  mesh.segments.clear();
  for (const auto& [from, to] : boundaries) mesh.segments.push_back({from, to, 0, 1, {}});
  geometry::writeMesh(mesh, picture);
}

int measureFile(const QualityOptions& options) {
  checkPicture(options.picture);
  measureOptions(options, true);  // faults of the options before those of the file
  geometry::MeshFile file = geometry::readMesh(options.mesh);
  addNotes(options, file);
  const geometry::MeasureOptions measure = measureOptions(options, file.hasFaces);
  const geometry::MeshMeasures measures = geometry::measureMesh(file.mesh, measure);
  if (!options.picture.empty()) drawPicture(options.picture, measure, file.mesh);
  if (options.format == "json") {
    nlohmann::ordered_json json = measuresJson(measures);
    json["notes"] = file.mesh.notes;
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
  } else {
    fmt::print("{}: {}", options.mesh, measuresText(measures));
    for (const std::string& note : file.mesh.notes) fmt::print("note: {}\n", note);
  }
  return kComplete;
}

}  // namespace

Action declareQuality(CLI::App& command) {
  const auto options = std::make_shared<QualityOptions>();
  command
      .add_option("MESH", options->mesh, "a mesh file: .vtu, .vtk, .msh, .msh2, .stl, .obj or .ply")
      ->type_name("")
      ->required();
  command
      .add_option(
          "-s,--size", options->size,
          "the target size, with which edge lengths are compared; default: the sizes in the "
          "file, or the median length")
      ->type_name("SIZE");
  command
      .add_option("--feature-angle", options->featureAngle,
                  "edges at which the surface turns by more than this angle are boundaries, too; "
                  "default 40 for a file without faces")
      ->type_name("DEGREES");
  command
      .add_option("--picture", options->picture,
                  "picture of the mesh coloured by quality: .png, .svg (planar meshes) or .html")
      ->type_name("FILE");
  command.add_option("--format", options->format, "pretty or json")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"pretty", "json"}).description(""));
  return [options] { return measureFile(*options); };
}

}  // namespace af2::cli
