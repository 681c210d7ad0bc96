#include "cli/meshing/model_formats.h"

#include <fmt/core.h>

#include <array>
#include <string_view>
#include <vector>

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

void addNames(const auto& formats, Names& names) {
  for (const auto& format : formats) names.push_back(format.name);
}

void addNames(ModelKind kind, Names& names) {
  switch (kind) {
    case ModelKind::Cad:
#if AF2_HAVE_OCC
      addNames(geometry::cadFormats(), names);
#endif
      return;
    case ModelKind::Faceted:
      return addNames(geometry::facetFormats(), names);
    case ModelKind::Planar:
      return addNames(geometry::planarFormats(), names);
  }
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
