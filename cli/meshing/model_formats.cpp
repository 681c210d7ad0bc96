#include "cli/meshing/model_formats.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "cli/program/usage_error.h"
#include "engine/base/error.h"
#include "geometry/base/words.h"
#include "geometry/faceted/facets.h"
#include "geometry/planar/planar_file.h"
#if AF2_HAVE_OCC
#include "geometry/occ/model/model.h"
#endif

namespace af2::cli {
namespace {

using Names = std::vector<std::string_view>;

struct Kind {
  ModelKind kind;
  const char* remark;
};
/// In the order in which texts list them.
constexpr std::array kKinds{Kind{ModelKind::Cad, "CAD"}, Kind{ModelKind::Faceted, "triangles"},
                            Kind{ModelKind::Planar, "planar"}};

/// Calls `take` with each format of the kind.
void forEachFormat(ModelKind kind, const auto& take) {
  switch (kind) {
    case ModelKind::Cad:
#if AF2_HAVE_OCC
      for (const geometry::FileFormat& format : geometry::cadFormats()) take(format);
#endif
      return;
    case ModelKind::Faceted:
      for (const geometry::FileFormat& format : geometry::facetFormats()) take(format);
      return;
    case ModelKind::Planar:
      for (const geometry::FileFormat& format : geometry::planarFormats()) take(format);
  }
}

void addNames(ModelKind kind, Names& names) {
  forEachFormat(kind, [&](const geometry::FileFormat& format) { names.push_back(format.name); });
}

/// Without the dots.
Names knownExtensions() {
  Names extensions;
  for (const Kind& kind : kKinds)
    forEachFormat(kind.kind, [&](const geometry::FileFormat& format) {
      for (const std::string_view extension : format.extensions)
        if (!extension.empty()) extensions.push_back(extension.substr(1));
    });
  return extensions;
}

}  // namespace

ModelKind modelKindOf(const std::filesystem::path& model) {
  if (geometry::formatOf(geometry::planarFormats(), model)) return ModelKind::Planar;
  if (geometry::formatOf(geometry::facetFormats(), model)) return ModelKind::Faceted;
  return ModelKind::Cad;
}

std::string formatNames(ModelKind kind, const char* conjunction) {
  Names names;
  addNames(kind, names);
  return geometry::listed(names, conjunction);
}

std::string formatNames(const char* conjunction) {
  Names names;
  for (const Kind& kind : kKinds) addNames(kind.kind, names);
  return geometry::listed(names, conjunction);
}

std::string modelExtensions() { return geometry::listed(knownExtensions(), "or"); }

void checkModelFormat(const std::string& format) {
  const Names known = knownExtensions();
  if (format.empty() || std::ranges::find(known, format) != known.end()) return;
  throw UsageError(fmt::format("--format {}: choose one of {}", format, modelExtensions()));
}

std::string modelHelp() {
  std::string help;
  for (const Kind& kind : kKinds) {
    const std::string names = formatNames(kind.kind, "or");
    if (names.empty()) continue;
    help += fmt::format("{}{} file ({})", help.empty() ? "" : ", ", names, kind.remark);
  }
  return help;
}

void refuseCadModel(const std::filesystem::path& model) {
  throw InputError(fmt::format(
      "'{}' is not a {} file, and this af2 was built without OpenCASCADE; build it with "
      "-DAF2_BUILD_OCC=ON",
      model.string(), formatNames("or")));
}

}  // namespace af2::cli
