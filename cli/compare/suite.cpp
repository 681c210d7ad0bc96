#include "cli/compare/suite.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "cli/compare/planar_domains.h"
#include "cli/inspect/inspect_tables.h"
#include "cli/meshing/mesh_run.h"
#include "cli/rules/rules_location.h"
#include "engine/base/error.h"
#include "geometry/base/box_tree.h"
#include "geometry/faceted/mesh_faceted.h"
#include "geometry/io/json_file.h"
#include "geometry/planar/mesh_planar.h"
#include "geometry/planar/planar_file.h"
#if AF2_HAVE_OCC
#include "geometry/occ/model/model.h"
#endif

namespace af2::cli {
namespace {

namespace fs = std::filesystem;
using geometry::MeshingOptions;
using geometry::ModelMesh;

constexpr double kSize = 0.05, kFineSize = 0.0125;
constexpr double kRandomSizes[] = {0.05, 0.025};
constexpr std::uint64_t kRandomDomains = 60, kManyRandomDomains = 240;
/// So many random domains are drawn.
constexpr std::uint64_t kDrawnRandomDomains = 8;

SuiteCase namedCase(const NamedDomain& named, double size) {
  const auto mesh = [named, size](const ComparedRules& rules, MeshingOptions options) {
    options.sizes.size = size;
    if (named.sizeAt)
      options.sizes.function = [size, at = named.sizeAt](const Point3& p) { return at(p, size); };
    return geometry::meshPlanar(named.domain, rules.algorithm, options);
  };
  return {fmt::format("{}, size {}", named.name, size), mesh, size == kSize};
}

SuiteCase randomCase(std::uint64_t seed, double size) {
  const auto mesh = [seed, size](const ComparedRules& rules, MeshingOptions options) {
    options.sizes.size = size;
    options.keepBoundary = true;
    return geometry::meshPlanar(randomDomain(seed, size), rules.algorithm, options);
  };
  return {fmt::format("random {}, size {}", seed, size), mesh,
          seed <= kDrawnRandomDomains && size == kSize};
}

SuiteCase fileCase(const fs::path& model, double size) {
  const auto mesh = [model, size](const ComparedRules& rules, MeshingOptions options) {
    MeshRequest request;
    request.model = model;
    request.options = options;
    request.options.sizes.size = size;
    return runMesh(request, rules.rules, {false, [&] { return options.stop; }});
  };
  return {fmt::format("{}, size {:.4g}", model.filename().string(), size), mesh,
          modelKindOf(model) == ModelKind::Planar, modelKindOf(model) == ModelKind::Cad};
}

/// The unit sphere: an octahedron whose triangles are divided again and again.
geometry::Facets sphere() {
  constexpr int kDivisions = 4;
  geometry::Facets facets;
  facets.name = "sphere";
  facets.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  facets.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                      {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int division = 0; division < kDivisions; ++division) {
    std::map<geometry::FacetEdge, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto count = static_cast<std::uint32_t>(facets.vertices.size());
      const auto [place, isNew] = middles.try_emplace(std::minmax(a, b), count);
      if (isNew) facets.vertices.push_back(unit(facets.vertices[a] + facets.vertices[b]));
      return place->second;
    };
    geometry::FacetTriangles finer;
    for (const auto& [a, b, c] : facets.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    facets.triangles = std::move(finer);
  }
  return facets;
}

void addSurfaces(Suite& suite) {
  const auto mesh = [facets = sphere()](const ComparedRules& rules, MeshingOptions options) {
    options.sizes.size = 0.15;
    return geometry::meshFaceted(facets, rules.algorithm, options);
  };
  suite.cases.push_back({"sphere, size 0.15", mesh});
#if AF2_HAVE_OCC
  const fs::path models = rulesDirectory().parent_path() / "examples" / "models";
  for (const auto& [name, size] : {std::pair{"cylinder.brep", 0.7}, {"die.brep", 0.7}}) {
    if (fs::exists(models / name))
      suite.cases.push_back(fileCase(models / name, size));
    else
      suite.notes.push_back(
          fmt::format("{} is not in '{}' and was left out", name, models.string()));
  }
#else
  suite.notes.push_back("CAD models were left out: this af2 was built without OpenCASCADE");
#endif
}

double extentOf(const fs::path& model) {
  geometry::Box3 box;
  switch (modelKindOf(model)) {
    case ModelKind::Planar:
      for (const Point2 p : geometry::readPlanar(model).points) box.add(Point3{p.x, p.y, 0});
      break;
    case ModelKind::Faceted:
      for (const Point3& p : geometry::readFacets(model).vertices) box.add(p);
      break;
    case ModelKind::Cad:
#if AF2_HAVE_OCC
      return geometry::readModel(model).diagonal();
#endif
      break;
  }
  return distance(box.low, box.high);
}

bool isModel(const fs::path& file) {
  if (!fs::is_regular_file(file)) return false;
#if AF2_HAVE_OCC
  const std::vector<geometry::FileFormat> formats = geometry::cadFormats();
  if (geometry::formatOf(std::span<const geometry::FileFormat>(formats), file)) return true;
#endif
  return modelKindOf(file) != ModelKind::Cad;
}

/// Sizes that a file `suite.json` gives.
struct SuiteSizes {
  double all = 0;  ///< 0: not given
  std::map<std::string, double> models;
};

SuiteSizes readSizes(const fs::path& file) {
  SuiteSizes sizes;
  if (!fs::exists(file)) return sizes;
  const geometry::JsonValue json = geometry::JsonValue::readFile(file);
  json.expectKeys({"size", "models"});
  if (json.has("size")) sizes.all = json.at("size").size();
  if (!json.has("models")) return sizes;
  for (const auto& [name, size] : json.at("models").members()) {
    if (!isModel(file.parent_path() / name))
      size.fail("there is no model '" + name + "' in this folder");
    sizes.models[name] = size.size();
  }
  return sizes;
}

}  // namespace

Suite builtInSuite(bool isLong) {
  Suite suite;
  for (const NamedDomain& named : namedDomains()) suite.cases.push_back(namedCase(named, kSize));
  if (isLong)
    for (const NamedDomain& named : namedDomains())
      suite.cases.push_back(namedCase(named, kFineSize));
  for (const double size : kRandomSizes)
    for (std::uint64_t seed = 1; seed <= (isLong ? kManyRandomDomains : kRandomDomains); ++seed)
      suite.cases.push_back(randomCase(seed, size));
  addSurfaces(suite);
  return suite;
}

Suite suiteIn(const fs::path& folder) {
  if (!fs::is_directory(folder))
    throw InputError(fmt::format("--suite {}: there is no such folder", folder.string()));
  std::vector<fs::path> models;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (isModel(entry.path())) models.push_back(entry.path());
  if (models.empty())
    throw InputError(
        fmt::format("--suite {}: the folder has no model; give {}", folder.string(), modelHelp()));
  std::ranges::sort(models);
  const SuiteSizes sizes = readSizes(folder / "suite.json");
  Suite suite;
  for (const fs::path& model : models) {
    const auto own = sizes.models.find(model.filename().string());
    const double size = own != sizes.models.end() ? own->second
                        : sizes.all > 0           ? sizes.all
                                                  : extentOf(model) / kSizesPerDiagonal;
    suite.cases.push_back(fileCase(model, size));
  }
  return suite;
}

}  // namespace af2::cli
