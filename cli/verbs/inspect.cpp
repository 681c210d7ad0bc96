// af2 inspect
#include <fmt/core.h>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "cli/inspect/inspect_domain.h"
#include "cli/inspect/inspect_tables.h"
#include "cli/meshing/imprint_request.h"
#include "cli/meshing/merge_request.h"
#include "cli/meshing/mesh_request.h"
#include "cli/meshing/model_formats.h"
#include "cli/program/exit_code.h"
#include "cli/program/number_lists.h"
#include "cli/program/supervisor.h"
#include "cli/program/text_files.h"
#include "cli/program/usage_error.h"
#include "cli/program/verbs.h"
#include "cli/rules/picture_format.h"
#if AF2_HAVE_OCC
#include "cli/inspect/defect_picture.h"
#include "cli/inspect/inspect_json.h"
#include "cli/meshing/contact_texts.h"
#include "cli/meshing/imprinted_model.h"
#include "cli/meshing/mesh_summary.h"
#include "geometry/occ/assembly/contacts.h"
#include "geometry/occ/heal/heal_model.h"
#include "geometry/occ/inspect/defects.h"
#include "geometry/occ/inspect/edge_list.h"
#include "geometry/occ/inspect/measures.h"
#include "geometry/occ/merge/mesh_merged.h"
#endif

namespace af2::cli {
namespace {

struct InspectOptions {
  std::string model, size, picture, healTolerance;
  ImprintFlags imprint;
  MergeOptions merge;
  bool brief = false, all = false, edges = false, heal = false, json = false, labels = false;
};

int inspectOther(const InspectOptions& options) {
  if (!options.picture.empty()) throw UsageError("--picture is for CAD models");
  if (options.json && (options.brief || options.all || options.edges))
    throw UsageError("--json lists everything but defects; leave out --brief, --all, --edges");
  if (options.heal) refuseHealing();
  checkedImprint(options.imprint, modelKindOf(options.model));
  checkedMerge(options.merge, modelKindOf(options.model));
  return inspectDomain({options.model, options.size.empty() ? 0 : parseSize("--size", options.size),
                        options.brief, options.all, options.edges, options.json});
}

}  // namespace
#if AF2_HAVE_OCC
namespace {

using geometry::Defect;

std::string lostText(const std::vector<std::string>& faces) {
  if (faces.empty()) return "";
  std::string names;
  for (const std::string& face : faces) names += (names.empty() ? "" : ", ") + face;
  return fmt::format("{} faces of the file could not be read: {}\n", faces.size(), names);
}

void printOverview(const geometry::Model& model) {
  const std::string unit = model.unit().empty() ? "" : " " + model.unit();
  fmt::print("{} faces, {} edges, {} vertices; diagonal {:.6g}{}\n", model.faceCount(),
             model.edgeCount(), model.vertexCount(), model.diagonal(), unit);
  if (!model.fileUnit().empty()) fmt::print("lengths in the file: {}\n", model.fileUnit());
  fmt::print("{}{}", lostText(model.lostFaces()), notesText(model.notes()));
  fmt::print("{}{}", healingText(model.healing()), imprintText(model.imprinting()));
  if (const std::string fault = imprintFault(model.imprinting()); !fault.empty())
    fmt::print("{}\n", fault);
}

void printSurfaceTypes(const geometry::Model& model) {
  std::map<std::string, int> counts;
  for (int face = 1; face <= model.faceCount(); ++face) ++counts[model.surfaceType(face)];
  for (const auto& [type, count] : counts) fmt::print("{:>8}  {}\n", count, type);
}

void printFaces(const geometry::Model& model) {
  fmt::print("{:>8}  {:<12}  {}\n", "face", "surface", "name");
  for (int face = 1; face <= model.faceCount(); ++face) {
    fmt::print("{:>8}  {:<12}  {}\n", face, model.surfaceType(face), model.faceName(face));
  }
}

struct InspectRequest {
  std::filesystem::path model;
  double size = 0;  ///< 0: derived from the diagonal
  bool heal = false;
  double healTolerance = 0;
  ImprintRequest imprint;
  MergeAsked merge;
  dsl::PictureFormat format = dsl::PictureFormat::Svg;
};

InspectRequest checkedRequest(const InspectOptions& options) {
  InspectRequest request;
  request.model = options.model;
  if (!options.size.empty()) request.size = parseSize("--size", options.size);
  request.heal = options.heal;
  request.healTolerance = checkedHealTolerance(options.heal, options.healTolerance);
  request.imprint = checkedImprint(options.imprint, ModelKind::Cad);
  request.merge = checkedMerge(options.merge, ModelKind::Cad);
  if (options.json && (options.brief || options.all || options.edges))
    throw UsageError("--json lists everything but defects; leave out --brief, --all, --edges");
  if (options.json && !options.size.empty() && !request.merge.isAsked)
    throw UsageError(
        "--json lists no defects, to which --size applies; leave it out, or add --merge");
  if (options.labels && options.picture.empty()) throw UsageError("--labels needs --picture");
  if (!options.picture.empty()) request.format = pictureFormatOf(options.picture, "--picture");
  return request;
}

/// The number of each face, and its name if it has one.
std::vector<PictureLabel> labelsOf(const geometry::Model& model, const InspectOptions& options) {
  std::vector<PictureLabel> labels;
  if (!options.labels) return labels;
  for (const auto& face : geometry::measuresOfFaces(model)) {
    if (!face) continue;
    const std::string& name = model.faceName(face->id);
    labels.push_back({face->place, std::to_string(face->id) + (name.empty() ? "" : " " + name)});
  }
  return labels;
}

double sizeOf(const InspectRequest& request, const geometry::Model& model) {
  return request.size > 0 ? request.size : model.diagonal() / kSizesPerDiagonal;
}

MergingAtSize mergingOf(const InspectRequest& request, const geometry::Model& model) {
  geometry::MeshingOptions sizes;
  sizes.sizes.size = sizeOf(request, model);
  return {sizes.sizes.size, geometry::mergingOf(model, sizes, request.merge.request)};
}

/// What a mesh would merge, instead of defects.
void showMerging(const InspectOptions& options, const InspectRequest& request,
                 const geometry::Model& model) {
  const auto [size, merging] = mergingOf(request, model);
  printMerging(merging, size);
  if (options.picture.empty()) return;
  writeText(options.picture, drawMerging(model, merging, request.format, labelsOf(model, options)));
  fmt::print("drew {} groups -> {}\n", merging.groups.size(), options.picture);
}

void showJson(const InspectOptions& options, const InspectRequest& request,
              const geometry::Model& model) {
  std::optional<MergingAtSize> found;
  if (request.merge.isAsked) found = mergingOf(request, model);
  fmt::print("{}", inspectJson(model, found));
  if (options.picture.empty()) return;
  const std::vector<PictureLabel> labels = labelsOf(model, options);
  writeText(options.picture, found ? drawMerging(model, found->merging, request.format, labels)
                                   : drawDefects(model, {}, request.format, labels));
}

int inspect(const InspectOptions& options, const InspectRequest& request) {
  geometry::Model model = geometry::readModel(request.model);
  if (request.heal) model = geometry::healModel(model, {request.healTolerance});
  model = imprintedModel(model, request.imprint, {});
  const int code = imprintFault(model.imprinting()).empty() ? kComplete : kPartial;
  if (options.json) {
    showJson(options, request, model);
    return code;
  }
  printOverview(model);
  options.brief ? printSurfaceTypes(model) : printFaces(model);
  if (options.edges) printEdges(geometry::edgesOf(model));
  printGroups(model.groups());
  if (options.brief && options.picture.empty() && !request.merge.isAsked) return kComplete;
  if (request.merge.isAsked) {
    showMerging(options, request, model);
    return code;
  }
  if (!options.brief) fmt::print("{}", contactTable(geometry::findContacts(model), options.all));
  const double size = sizeOf(request, model);
  const std::vector<Defect> defects = geometry::findDefects(model, size);
  if (!options.brief) printDefects(defects, size, options.all);
  if (!options.picture.empty()) {
    writeText(options.picture,
              drawDefects(model, defects, request.format, labelsOf(model, options)));
    fmt::print("drew {} defects -> {}\n", defects.size(), options.picture);
  }
  return code;
}

/// In a supervised process, because OpenCASCADE may crash or hang while it reads or checks a model.
int inspectSafely(const InspectOptions& options) {
  const InspectRequest request = checkedRequest(options);
  std::error_code missing;
  const auto bytes = std::filesystem::file_size(request.model, missing);
  RunLimits limits;
  limits.first = secondsToRead(missing ? 0 : bytes);
  if (request.imprint.isAsked) limits.first += 2 * kImprintSeconds;
  return supervise(limits, [&](RunLog&, const GivenUp&) { return inspect(options, request); });
}

}  // namespace
#endif

Action declareInspect(CLI::App& command) {
  const auto options = std::make_shared<InspectOptions>();
  command.add_option("MODEL", options->model, modelHelp())->type_name("")->required();
  command.add_flag("--brief", options->brief,
                   "count the faces of each kind instead of listing them; do not look for defects");
  command.add_flag("--edges", options->edges,
                   "also list the edges, with their lengths, ends and faces, for --edge-size and "
                   "--boundary of af2 mesh");
  command
      .add_option("-s,--size", options->size,
                  "mesh size with which defects are compared; default: a fortieth of the diagonal")
      ->type_name("SIZE");
  command.add_flag("--all", options->all, "list all defects, not only the first ten of each kind");
  command
      .add_option("--picture", options->picture,
                  "picture of the model with its defects marked, .svg or .png")
      ->type_name("FILE");
  command.add_flag("--labels", options->labels,
                   "with --picture: write the number and the name of each face on it");
  command.add_flag("--json", options->json,
                   "print faces, edges, solids and groups with their measures as JSON, instead of "
                   "tables; with --merge, also what would be merged");
  declareHealing(command, options->heal, options->healTolerance);
  declareImprint(command, options->imprint);
  declareMerge(command, options->merge);
  return [options]() -> int {
    if (modelKindOf(options->model) != ModelKind::Cad) return inspectOther(*options);
#if AF2_HAVE_OCC
    return inspectSafely(*options);
#else
    refuseCadModel(options->model);
#endif
  };
}

}  // namespace af2::cli
