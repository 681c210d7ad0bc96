#include "cli/playground/sample_mesh.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "dsl/load/loaded_file.h"
#include "engine/base/error.h"
#include "engine/run/algorithm.h"
#include "geometry/mesh/quality.h"
#include "geometry/picture/category_colors.h"
#include "geometry/picture/svg_picture.h"
#include "geometry/planar/mesh_planar.h"

namespace af2::playground {
namespace {

using geometry::FaceReport;
using geometry::FaceStatus;
using geometry::ModelMesh;
using geometry::Rgb;
using Json = nlohmann::json;

/// What made elements: the index of a rule or, after these, of what makes elements without one.
constexpr std::size_t kOptimization = ~std::size_t{0};

std::size_t makerOf(const ElementOrigin& origin) {
  return origin.isChanged ? kOptimization : origin.rule;
}

struct Maker {
  std::size_t id = 0;
  std::size_t count = 0;
  Rgb color;
};

/// The most frequent rule first; the elements that optimisation changed come last.
std::vector<Maker> makersOf(const ModelMesh& mesh) {
  std::map<std::size_t, std::size_t> counts;
  for (const ElementOrigin& origin : mesh.origins) ++counts[makerOf(origin)];
  std::vector<Maker> makers;
  for (const auto& [id, count] : counts) makers.push_back({id, count, {}});
  std::ranges::stable_sort(makers, [](const Maker& p, const Maker& q) {
    if ((p.id == kOptimization) != (q.id == kOptimization)) return q.id == kOptimization;
    return p.count > q.count;
  });
  for (std::size_t i = 0; i < makers.size(); ++i)
    makers[i].color =
        makers[i].id == kOptimization ? geometry::kColorOfNone : geometry::categoryColor(i);
  return makers;
}

std::string titleOf(const Maker& maker, const ModelMesh& mesh, std::size_t ruleCount) {
  if (maker.id == kOptimization) return "changed by optimization";
  const std::string& name = mesh.ruleNames[maker.id];
  return maker.id < ruleCount ? name : "without a rule: " + name;
}

int lineOf(const Maker& maker, const dsl::LoadedFile& file) {
  if (maker.id >= file.rules.size()) return 0;
  const dsl::CompiledRule& rule = file.rules[maker.id];
  return rule.home == &file.main() ? rule.titlePlace.line : 0;
}

Json makersJson(const std::vector<Maker>& makers, const ModelMesh& mesh,
                const dsl::LoadedRules& loaded) {
  Json list = Json::array();
  for (const Maker& maker : makers)
    list.push_back({{"title", titleOf(maker, mesh, loaded.rules->rules().size())},
                    {"line", lineOf(maker, *loaded.file)},
                    {"count", maker.count},
                    {"color", geometry::hexOf(maker.color)}});
  return list;
}

geometry::ElementColor colorByMaker(const std::vector<Maker>& makers, const ModelMesh& mesh) {
  std::map<std::size_t, Rgb> colors;
  for (const Maker& maker : makers) colors[maker.id] = maker.color;
  return [colors, &mesh](std::size_t e) { return colors.at(makerOf(mesh.origins[e])); };
}

Json notesOf(const ModelMesh& mesh, const std::stop_token& stop) {
  Json notes = Json::array();
  if (stop.stop_requested()) notes.push_back("The time was over: this is the mesh so far.");
  for (const FaceReport& face : mesh.faces) {
    if (face.status == FaceStatus::Failed) notes.push_back("The mesh failed: " + face.reason);
    if (face.status != FaceStatus::Failed && !face.stuck.empty())
      notes.push_back("The front got stuck and was closed without a rule.");
  }
  for (const std::string& finding : mesh.findings) notes.push_back(finding);
  return notes;
}

Json jsonOf(const ModelMesh& mesh, const dsl::LoadedRules& loaded, const SampleRequest& request,
            const std::stop_token& stop) {
  const auto quads =
      static_cast<std::size_t>(std::ranges::count_if(mesh.elements, &Element::isQuad));
  const geometry::MeshQuality quality = geometry::measureQuality(mesh);
  const std::vector<Maker> makers = makersOf(mesh);
  return {{"fault", ""},
          {"svg", geometry::svgPicture(mesh, request.byRule ? colorByMaker(makers, mesh)
                                                            : geometry::colorByQuality(mesh))},
          {"makers", makersJson(makers, mesh, loaded)},
          {"elements", mesh.elements.size()},
          {"triangles", mesh.elements.size() - quads},
          {"quads", quads},
          {"withoutRule", elementsWithoutRule(mesh).total()},
          {"quality",
           {{"min", quality.min},
            {"mean", quality.mean},
            {"minAngle", quality.minAngle},
            {"maxAngle", quality.maxAngle}}},
          {"notes", notesOf(mesh, stop)}};
}

/// Why the rules cannot mesh; empty if they can.
std::string faultOfRules(const dsl::LoadedRules& loaded) {
  if (loaded.rules) return dsl::missingText(*loaded.file);
  for (const dsl::Diagnostic& d : loaded.diagnostics)
    if (d.severity == dsl::Severity::Error)
      return fmt::format("Line {}: {}", d.place.line, d.message);
  return "The file has no rules.";
}

}  // namespace

Json sampleMesh(const std::string& path, const std::string& text, const dsl::LoadOptions& loading,
                const SampleRequest& request, const std::stop_token& stop) {
  const dsl::LoadedRules loaded = dsl::loadRulesFromText(path, text, loading);
  if (const std::string fault = faultOfRules(loaded); !fault.empty()) return {{"fault", fault}};
  geometry::MeshingOptions options;
  options.sizes.size = request.size->size;
  options.optimize = request.optimize;
  options.stop = stop;
  try {
    const ModelMesh mesh =
        geometry::meshPlanar(request.domain->make(), AF2Algorithm(loaded.rules), options);
    if (mesh.elements.empty()) {
      const Json notes = notesOf(mesh, stop);
      return {{"fault", notes.empty() ? "The rules made no element." : notes.front()}};
    }
    return jsonOf(mesh, loaded, request, stop);
  } catch (const std::exception& error) {
    return {{"fault", error.what()}};
  }
}

}  // namespace af2::playground
