// The outline of a file: symbols and foldable ranges.
#include <algorithm>
#include <array>
#include <cctype>

#include "cli/lsp/server.h"
#include "cli/lsp/uri.h"
#include "cli/lsp/workspace.h"

namespace af2::lsp {
namespace {

using dsl::Symbol;
using dsl::SymbolKind;

/// Kinds with the numbers of the protocol.
int kindNumber(SymbolKind kind) {
  constexpr int kModule = 2, kNamespace = 3, kClass = 5, kField = 8, kInterface = 11,
                kFunction = 12, kVariable = 13, kConstant = 14, kEvent = 24, kOperator = 25;
  switch (kind) {
    case SymbolKind::Import:
      return kModule;
    case SymbolKind::RuleSet:
      return kNamespace;
    case SymbolKind::Rule:
      return kClass;
    case SymbolKind::Template:
      return kInterface;
    case SymbolKind::Function:
    case SymbolKind::Metric:
      return kFunction;
    case SymbolKind::Constant:
      return kConstant;
    case SymbolKind::Test:
    case SymbolKind::Property:
      return kEvent;
    case SymbolKind::Vertex:
    case SymbolKind::NewVertex:
    case SymbolKind::TestVertex:
      return kField;
    case SymbolKind::Let:
      return kVariable;
    case SymbolKind::Parameter:
      return kOperator;
  }
  return kVariable;
}

bool isInner(const Symbol& s) {
  return s.kind == SymbolKind::Vertex || s.kind == SymbolKind::NewVertex ||
         s.kind == SymbolKind::Let;
}

/// The protocol forbids empty names, but a title can be empty while it is typed.
std::string nameOf(const Symbol& symbol) {
  const bool isBlank = std::ranges::all_of(
      symbol.name, [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; });
  return isBlank ? std::string("(") + wordFor(symbol.kind) + ")" : symbol.name;
}

Json symbolJson(const TextMap& map, const Symbol& symbol) {
  const dsl::Span whole = cover(symbol.whole, symbol.definition);
  return {{"name", nameOf(symbol)},
          {"detail", wordFor(symbol.kind)},
          {"kind", kindNumber(symbol.kind)},
          {"range", map.range(whole)},
          {"selectionRange", map.range(symbol.definition)}};
}

/// The items of a file; for rules also their vertices, values and mirrored rules.
Json nested(const Analysis& analysis, const TextMap& map) {
  const auto& symbols = analysis.symbols.symbols();
  Json list = Json::array();
  const auto isWritten = [&](const Symbol& s) {
    return s.home == &analysis.main() && s.definition.end > s.definition.begin;
  };
  for (std::size_t i = 0; i < symbols.size(); ++i) {
    if (!isWritten(symbols[i]) || !symbols[i].isGlobal() || symbols[i].isMirror) continue;
    Json json = symbolJson(map, symbols[i]);
    Json children = Json::array();
    for (const Symbol& inner : symbols) {
      const bool isOwn = inner.owner == i && isInner(inner);
      const bool isMirror = inner.isMirror && inner.item == symbols[i].item;
      if (isWritten(inner) && (isOwn || isMirror)) children.push_back(symbolJson(map, inner));
    }
    if (!children.empty()) json["children"] = std::move(children);
    list.push_back(std::move(json));
  }
  return list;
}

Json information(const std::string& uri, const TextMap& map, const Symbol& symbol) {
  return {{"name", nameOf(symbol)},
          {"kind", kindNumber(symbol.kind)},
          {"containerName", wordFor(symbol.kind)},
          {"location", {{"uri", uri}, {"range", map.range(symbol.definition)}}}};
}

void addFlat(const std::string& uri, const Analysis& analysis, const TextMap& map,
             const std::string& query, Json& list) {
  const auto lower = [](std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
  };
  for (const Symbol& s : analysis.symbols.symbols()) {
    const bool isShown = s.home == &analysis.main() && s.isGlobal() &&
                         s.definition.end > s.definition.begin &&
                         lower(s.name).find(lower(query)) != std::string::npos;
    if (isShown) list.push_back(information(uri, map, s));
  }
}

std::optional<Json> documentSymbols(Session& session, const Json&, const Json& params) {
  const auto document = session.documentOf(params);
  const auto analysis = session.analysis(*document);
  const TextMap map = session.map(document->text);
  if (session.client.nestsSymbols) return nested(*analysis, map);
  Json list = Json::array();
  addFlat(document->uri, *analysis, map, "", list);
  return list;
}

std::optional<Json> workspaceSymbols(Session& session, const Json&, const Json& params) {
  const auto query = params.value("query", std::string());
  Json list = Json::array();
  const auto add = [&](Document& document) {
    addFlat(document.uri, *session.analysis(document), session.map(document.text), query, list);
  };
  for (const auto& document : session.openDocuments()) add(*document);
  for (const std::string& path : ruleFilesOf(session)) {
    if (session.findOpenFile(path)) continue;
    try {
      add(*session.document(uriOf(path)));
    } catch (const RequestError&) {
      continue;
    }
  }
  return list;
}

Json fold(std::size_t first, std::size_t last, const char* kind = nullptr) {
  Json json{{"startLine", first}, {"endLine", last}};
  if (kind) json["kind"] = kind;
  return json;
}

/// Blocks, runs of comment lines, and runs of imports.
std::optional<Json> folding(Session& session, const Json&, const Json& params) {
  const auto document = session.documentOf(params);
  const auto analysis = session.analysis(*document);
  const TextMap map = session.map(document->text);
  const dsl::ParsedFile& parsed = analysis->main().parsed;
  Json list = Json::array();
  std::optional<std::pair<std::size_t, std::size_t>> imports;
  for (const dsl::Item& item : parsed.file.items) {
    if (item.span.end <= item.span.begin) continue;
    const std::size_t first = map.lineOf(item.span.begin), last = map.lineOf(item.span.end - 1);
    // The closing brace stays visible.
    if (last > first + 1) list.push_back(fold(first, last - 1));
    const bool isImport = std::holds_alternative<dsl::Import>(item.content) ||
                          std::holds_alternative<dsl::Use>(item.content);
    if (isImport) imports = {imports ? imports->first : first, last};
  }
  if (imports && imports->second > imports->first)
    list.push_back(fold(imports->first, imports->second, "imports"));
  for (std::size_t i = 0; i < parsed.comments.size();) {
    std::size_t k = i;
    const auto lineOf = [&](std::size_t c) { return map.lineOf(parsed.comments[c].span.begin); };
    while (k + 1 < parsed.comments.size() && parsed.comments[k + 1].ownLine &&
           lineOf(k + 1) == lineOf(k) + 1)
      ++k;
    if (k > i && parsed.comments[i].ownLine) list.push_back(fold(lineOf(i), lineOf(k), "comment"));
    i = k + 1;
  }
  return list;
}

constexpr std::array kOutlineMethods{
    Method{"textDocument/documentSymbol", documentSymbols},
    Method{"workspace/symbol", workspaceSymbols},
    Method{"textDocument/foldingRange", folding},
};

}  // namespace

std::span<const Method> outlineMethods() { return kOutlineMethods; }

}  // namespace af2::lsp
