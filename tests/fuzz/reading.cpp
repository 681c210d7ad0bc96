#include "tests/fuzz/reading.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string_view>

#include "dsl/format/printer.h"
#include "dsl/load/rule_file.h"
#include "dsl/netgen/rls_import.h"
#include "dsl/run/evaluate.h"
#include "dsl/run/rule_tests.h"
#include "engine/base/error.h"
#include "geometry/faceted/mesh_faceted.h"
#include "geometry/io/boundary_file.h"
#include "geometry/io/size_file.h"
#include "geometry/planar/in2d_file.h"
#include "geometry/planar/mesh_planar.h"
#include "geometry/quality/mesh_measures.h"
#include "geometry/reading/read_mesh.h"
#include "geometry/reading/size_field.h"
#include "tests/support/test_folder.h"

namespace af2::fuzz {
namespace {

namespace fs = std::filesystem;

using dsl::Diagnostic;

void promise(bool holds, const char* what) {
  if (!holds) throw std::logic_error(std::string("does not hold: ") + what);
}

/// Every finding has a place in its file and can be written in every form.
void checkFindings(const std::vector<Diagnostic>& found, const std::string& text) {
  const auto lines = 1 + std::count(text.begin(), text.end(), '\n');
  promise(found.size() <= dsl::DiagnosticList::kMax, "at most so many findings as are shown");
  for (const Diagnostic& d : found) {
    promise(!d.message.empty(), "a finding has a message");
    promise(d.place.line >= 0 && d.place.line <= lines, "a finding lies in the file");
    promise(d.place.column >= 0 && d.place.endLine >= d.place.line, "its span runs forwards");
  }
  promise(!dsl::toPretty(found).empty() || found.empty(), "findings can be written");
  promise(!dsl::toJson(found).empty() && !dsl::toSarif(found).empty(), "for machines, too");
}

/// Formatting gives the same rules, and formatting again the same text.
void checkFormat(const std::string& text, const dsl::LoadedRules& loaded) {
  const std::string once = dsl::format("x.af2", text).text;
  if (once.empty()) return;
  promise(dsl::format("x.af2", once).text == once, "formatting twice changes nothing");
  const dsl::LoadedRules again = dsl::loadRulesFromText("x.af2", once);
  promise((again.rules == nullptr) == (loaded.rules == nullptr), "formatting keeps what is sound");
  if (!loaded.rules) return;
  promise(again.rules->rules().size() == loaded.rules->rules().size(), "formatting keeps rules");
}

/// The first rules at their reference match.
void evaluateSome(const RuleSet& rules) {
  constexpr std::size_t kMax = 5;
  for (std::size_t i = 0; i < std::min(kMax, rules.rules().size()); ++i) {
    dsl::EvalRequest request;
    request.rule = rules.rules()[i].name();
    request.points = {{0.5, 0.3}, {2, 2}};
    request.segments = {{{-1, 0.5}, {2, 0.5}}};
    try {
      promise(!dsl::toJson(dsl::evaluateRule(rules, request)).empty(), "an answer can be written");
    } catch (const InputError&) {
      // level 1 lies outside of the rule's levels
    }
  }
}

/// A file with this text; that it cannot be used may be told, by InputError.
void readAs(const char* extension, const std::string& text,
            const std::function<void(const fs::path&)>& reader) {
  const testing::TestFile file(std::string("input") + extension, text);
  try {
    reader(file.path());
  } catch (const InputError& told) {
    promise(std::string_view(told.what()).size() > 0, "what is wrong is told");
  }
}

void findRegions(const geometry::PlanarDomain& domain) {
  const auto count = static_cast<int>(domain.points.size());
  for (const auto& segment : domain.segments)
    promise(segment.from >= 0 && segment.from < count && segment.to >= 0 && segment.to < count,
            "segments join points");
  geometry::MeshingOptions options;
  options.sizes.size = 1;
  const geometry::DomainModel model = geometry::planarModel(domain, options);
  promise(!model.faces.empty(), "there are regions, or errors");
}

void findFaces(const fs::path& file) {
  const geometry::Facets facets = geometry::readFacets(file);
  promise(facets.group.empty() || facets.group.size() == facets.triangles.size(),
          "each triangle has its part");
  for (const auto& triangle : facets.triangles)
    for (const std::uint32_t corner : triangle)
      promise(corner < facets.vertices.size(), "triangles have corners");
  for (const auto& t : facets.triangles)
    promise(t[0] != t[1] && t[1] != t[2] && t[2] != t[0], "triangles have three corners");
  geometry::MeshingOptions options;
  options.sizes.size = 1;
  promise(!geometry::facetedModel(facets, options).faces.empty(), "there are faces, or errors");
}

void measure(const fs::path& file) {
  const geometry::ModelMesh mesh = geometry::readMesh(file).mesh;
  const geometry::MeshMeasures measures = geometry::measureMesh(mesh, {0, 40});
  promise(measures.elements() == mesh.elements.size(), "each element is measured");
  promise(measures.vertices <= mesh.vertices.size(), "only corners of elements count");
}

}  // namespace

void tryRuleFile(const std::string& text) {
  const dsl::LoadedRules loaded = dsl::loadRulesFromText("x.af2", text);
  promise((loaded.rules == nullptr) == dsl::hasErrors(loaded.diagnostics),
          "there are rules, or errors");
  checkFindings(loaded.diagnostics, text);
  checkFormat(text, loaded);
  if (!loaded.rules) return;
  evaluateSome(*loaded.rules);
  dsl::runRuleTests(loaded);
}

void tryRlsFile(const std::string& text) {
  const dsl::ImportedRules imported = dsl::importRls("x.rls", text);
  checkFindings(imported.diagnostics, text);
  promise(imported.text.empty() == dsl::hasErrors(imported.diagnostics), "a text, or errors");
  if (imported.text.empty()) return;
  promise(!dsl::format("x.af2", imported.text).text.empty(), "an imported file can be read");
}

void tryPolyFile(const std::string& text) {
  readAs(".poly", text, [](const fs::path& file) { findRegions(geometry::readPoly(file)); });
}

void tryIn2dFile(const std::string& text) {
  readAs(".in2d", text,
         [](const fs::path& file) { findRegions(geometry::domainOf(geometry::readIn2d(file))); });
}

void tryStlFile(const std::string& text) { readAs(".stl", text, findFaces); }

void tryObjFile(const std::string& text) { readAs(".obj", text, findFaces); }

void tryVtuFile(const std::string& text) { readAs(".vtu", text, measure); }

void tryVtkFile(const std::string& text) { readAs(".vtk", text, measure); }

void tryMshFile(const std::string& text) { readAs(".msh", text, measure); }

void tryPlyFile(const std::string& text) { readAs(".ply", text, measure); }

void tryOffFile(const std::string& text) { readAs(".off", text, measure); }

void askForSizes(const geometry::SizeSources& sources) {
  const geometry::PositionSize size = sizeFrom(sources, 0.3);
  for (const double x : {-1e300, -3.0, 0.0, 0.7, 1e9})
    promise(size.at(Point3{x, 1, -x}) > 0, "sizes are positive");
}

void trySizeFile(const std::string& text) {
  readAs(".json", text,
         [](const fs::path& file) { askForSizes(geometry::readSizeFile(file).sources); });
}

void tryPosFile(const std::string& text) {
  readAs(".pos", text, [](const fs::path& file) {
    geometry::SizeSources sources;
    sources.cells = {geometry::readSizeField({file, ""})};
    askForSizes(sources);
  });
}

void tryEdgePointFile(const std::string& text) {
  readAs(".json", text, [](const fs::path& file) {
    for (const auto& [edge, points] : geometry::readEdgePoints(file))
      promise(edge > 0, "edges count from 1");
  });
}

}  // namespace af2::fuzz
