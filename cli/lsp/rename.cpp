// Rename: changes all occurrences at once, or says why it cannot.
#include <algorithm>
#include <array>

#include "cli/lsp/server.h"
#include "cli/lsp/workspace.h"
#include "dsl/program/builtins.h"
#include "dsl/text/characters.h"
#include "dsl/text/keywords.h"

namespace af2::lsp {
namespace {

using dsl::Occurrence;
using dsl::Symbol;
using dsl::SymbolKind;

[[noreturn]] void refuse(const std::string& why) {
  throw RequestError(ErrorCode::RequestFailed, why);
}

bool isCalled(SymbolKind kind) {
  return kind == SymbolKind::Function || kind == SymbolKind::Metric || kind == SymbolKind::Template;
}

/// The symbol under the cursor.
Occurrence renamedAt(const Session& session, const Place& place) {
  const auto found = place.analysis->symbols.at(place.analysis->main(), place.offset);
  if (!found) refuse("there is no name here that can be renamed");
  const Symbol& symbol = place.analysis->symbols[found->symbol];
  if (symbol.kind == SymbolKind::Vertex && (symbol.name == "a" || symbol.name == "b"))
    refuse("'" + symbol.name + "' is an end of the base edge in every rule and keeps its name");
  if (session.uriOfModule(*place.document, *place.analysis, *symbol.home).empty())
    refuse("'" + symbol.name + "' is built into AF2");
  if (symbol.kind == SymbolKind::Import) {
    const auto* import = std::get_if<dsl::Import>(&symbol.item->content);
    if (import && !import->alias)
      refuse("'" + symbol.name + "' is the name of the file; give the import its own name with " +
             "`as` first");
  }
  return *found;
}

void checkWord(const Symbol& symbol, const std::string& name) {
  if (!dsl::isPlainName(name))
    refuse(
        "'" + name +
        "' is not a name: names consist of letters, digits and '_' and do not begin with a digit");
  if (dsl::isReserved(name)) refuse("'" + name + "' is a keyword and cannot be a name");
  if (isCalled(symbol.kind) && dsl::isBuiltin(name))
    refuse("'" + name + "' is a function of the language");
  if (!isCalled(symbol.kind) && (name == "q" || name == "class"))
    refuse("'" + name + "' is the quality level");
  if (name == "deg") refuse("'deg' is the unit of angles");
  const bool isVertex = symbol.kind == SymbolKind::Vertex || symbol.kind == SymbolKind::NewVertex;
  if (isVertex && (name == "a" || name == "b"))
    refuse("'" + name + "' is an end of the base edge in every rule");
}

void checkTitle(const Analysis& analysis, const Symbol& symbol, const std::string& title) {
  if (title.empty() || title.find_first_of("\r\n") != std::string::npos)
    refuse("a title must be one line of text");
  if (dsl::titleParameters(title) != dsl::titleParameters(symbol.name))
    refuse("the title \"" + symbol.name +
           "\" contains the parameters of a family; the new title must "
           "contain the same ones");
  for (const Symbol& other : analysis.symbols.symbols()) {
    if (&other == &symbol || other.kind != symbol.kind) continue;
    if (other.name == title || dsl::isTitleOf(other.name, title) ||
        dsl::isTitleOf(title, other.name))
      refuse(std::string("there is already a ") + wordFor(other.kind) + " \"" + other.name + "\"");
  }
}

/// The new name must not be visible already where this one is used, and must not change the meaning
/// of other names where this one will be visible.
void checkClashes(const Analysis& analysis, const Symbol& symbol, std::size_t id,
                  const std::string& name) {
  const auto clash = [&](const Symbol& other) {
    const int line = other.home->source.lineOf(other.definition.begin);
    const std::string where =
        other.definition.end > 0 ? " (line " + std::to_string(line) + ")" : "";
    refuse("'" + name + "' is already the name of a " + wordFor(other.kind) + " here" + where);
  };
  for (const Symbol& other : analysis.symbols.symbols()) {
    if (other.name != name || other.isTitle() || &other == &symbol) continue;
    const bool isSameSpace = isCalled(other.kind) == isCalled(symbol.kind);
    const bool isSameFile = other.home == symbol.home;
    const bool overlaps =
        other.scope.begin < symbol.scope.end && symbol.scope.begin < other.scope.end;
    if (isSameSpace && isSameFile && overlaps && other.kind != SymbolKind::Import) clash(other);
    if (other.kind == SymbolKind::Import && symbol.kind == SymbolKind::Import && isSameFile)
      clash(other);
  }
  // Where another file uses the name, the new name may already have a meaning there.
  for (const auto& module : analysis.loaded.file->modules)
    for (const Occurrence& o : analysis.symbols.occurrencesIn(*module)) {
      if (o.symbol != id) continue;
      for (const std::size_t seen : analysis.symbols.visibleAt(*module, o.span.begin)) {
        const Symbol& other = analysis.symbols[seen];
        if (&other != &symbol && other.name == name && !other.isTitle() &&
            isCalled(other.kind) == isCalled(symbol.kind) && other.kind != SymbolKind::Import)
          clash(other);
      }
    }
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

std::string unquoted(std::string_view text) {
  std::string result;
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    if (text[i] == '\\' && i + 2 < text.size()) ++i;
    result += text[i];
  }
  return result;
}

/// The new text of an occurrence.
std::string replacement(const Symbol& symbol, std::string_view written, const std::string& name) {
  if (!symbol.isTitle()) return name;
  const std::string title = unquoted(written);
  return quoted(title == symbol.name ? name : dsl::retitled(symbol.name, title, name));
}

Json editsIn(const Session& session, const Symbol& symbol, const FileOccurrences& file,
             const std::string& name) {
  const TextMap map = session.map(file.text);
  Json edits = Json::array();
  for (const Occurrence& o : file.occurrences) {
    const std::string_view written =
        std::string_view(file.text).substr(o.span.begin, o.span.end - o.span.begin);
    edits.push_back(
        {{"range", map.range(o.span)}, {"newText", replacement(symbol, written, name)}});
  }
  return edits;
}

/// For a title, the part inside the quotes.
dsl::Span spanToEdit(const Symbol& symbol, dsl::Span span) {
  return symbol.isTitle() ? dsl::Span{span.begin + 1, span.end - 1} : span;
}

std::optional<Json> prepare(Session& session, const Json&, const Json& params) {
  const Place place = session.placeOf(params);
  const Occurrence found = renamedAt(session, place);
  const Symbol& symbol = place.analysis->symbols[found.symbol];
  const dsl::Span span = spanToEdit(symbol, found.span);
  return Json{{"range", session.map(place.document->text).range(span)},
              {"placeholder", symbol.name}};
}

std::optional<Json> rename(Session& session, const Json&, const Json& params) {
  const Place place = session.placeOf(params);
  const auto name = params.at("newName").get<std::string>();
  const Occurrence found = renamedAt(session, place);
  const Symbol& symbol = place.analysis->symbols[found.symbol];
  Json changes = Json::object();
  if (name == symbol.name) return Json{{"changes", changes}};
  if (symbol.isTitle()) {
    checkTitle(*place.analysis, symbol, name);
  } else {
    checkWord(symbol, name);
    checkClashes(*place.analysis, symbol, found.symbol, name);
  }
  for (const FileOccurrences& file : occurrencesEverywhere(session, place, found.symbol))
    changes[file.uri] = editsIn(session, symbol, file, name);
  return Json{{"changes", std::move(changes)}};
}

constexpr std::array kRenameMethods{
    Method{"textDocument/prepareRename", prepare},
    Method{"textDocument/rename", rename},
};

}  // namespace

std::span<const Method> renameMethods() { return kRenameMethods; }

}  // namespace af2::lsp
