// Definition, references and highlights: where a name is defined and used.
#include <algorithm>
#include <array>

#include "cli/lsp/server.h"
#include "cli/lsp/workspace.h"

namespace af2::lsp {
namespace {

using dsl::Occurrence;
using dsl::Symbol;

Json locationOf(const Session& session, const Document& document, const Analysis& analysis,
                const dsl::Module& module, dsl::Span span) {
  const std::string uri = session.uriOfModule(document, analysis, module);
  if (uri.empty()) return nullptr;
  return {{"uri", uri}, {"range", session.map(module.source.text()).range(span)}};
}

/// The path of an import leads to the file.
const Symbol* importAt(const Place& place) {
  for (const Symbol& s : place.analysis->symbols.symbols())
    if (s.kind == dsl::SymbolKind::Import && s.home == &place.analysis->main() &&
        s.whole.begin <= place.offset && place.offset <= s.whole.end)
      return &s;
  return nullptr;
}

std::optional<Json> definition(Session& session, const Json&, const Json& params) {
  const Place place = session.placeOf(params);
  const Analysis& analysis = *place.analysis;
  if (const Symbol* import = importAt(place)) {
    if (!import->target) return Json(nullptr);
    return locationOf(session, *place.document, analysis, *import->target, {0, 0});
  }
  const auto found = analysis.symbols.at(analysis.main(), place.offset);
  if (!found) return Json(nullptr);
  const Symbol& symbol = analysis.symbols[found->symbol];
  // The ends of the base edge exist without being written.
  const bool isWritten = symbol.definition.end > symbol.definition.begin;
  return locationOf(session, *place.document, analysis, *symbol.home,
                    isWritten ? symbol.definition : symbol.whole);
}

std::optional<Json> references(Session& session, const Json&, const Json& params) {
  const Place place = session.placeOf(params);
  const auto found = place.analysis->symbols.at(place.analysis->main(), place.offset);
  if (!found) return Json(nullptr);
  const bool withDefinition =
      params.contains("context") && params["context"].value("includeDeclaration", true);
  Json list = Json::array();
  for (const FileOccurrences& file : occurrencesEverywhere(session, place, found->symbol)) {
    const TextMap map = session.map(file.text);
    for (const Occurrence& o : file.occurrences)
      if (withDefinition || !o.isDefinition)
        list.push_back({{"uri", file.uri}, {"range", map.range(o.span)}});
  }
  return list;
}

std::optional<Json> highlights(Session& session, const Json&, const Json& params) {
  constexpr int kRead = 2, kWrite = 3;
  const Place place = session.placeOf(params);
  const dsl::Module& main = place.analysis->main();
  const auto found = place.analysis->symbols.at(main, place.offset);
  if (!found) return Json(nullptr);
  const TextMap map = session.map(place.document->text);
  Json list = Json::array();
  for (const Occurrence& o : place.analysis->symbols.occurrencesIn(main))
    if (o.symbol == found->symbol)
      list.push_back({{"range", map.range(o.span)}, {"kind", o.isDefinition ? kWrite : kRead}});
  return list;
}

/// The paths of imports, as links.
std::optional<Json> links(Session& session, const Json&, const Json& params) {
  const auto document = session.documentOf(params);
  const auto analysis = session.analysis(*document);
  const TextMap map = session.map(document->text);
  Json list = Json::array();
  for (const Symbol& s : analysis->symbols.symbols()) {
    if (s.kind != dsl::SymbolKind::Import || s.home != &analysis->main() || !s.target) continue;
    const std::string uri = session.uriOfModule(*document, *analysis, *s.target);
    const auto* import = std::get_if<dsl::Import>(&s.item->content);
    if (!uri.empty() && import)
      list.push_back({{"range", map.range(import->path.span)}, {"target", uri}});
  }
  return list;
}

constexpr std::array kNavigationMethods{
    Method{"textDocument/definition", definition},
    Method{"textDocument/references", references},
    Method{"textDocument/documentHighlight", highlights},
    Method{"textDocument/documentLink", links},
};

}  // namespace

std::span<const Method> navigationMethods() { return kNavigationMethods; }

}  // namespace af2::lsp
