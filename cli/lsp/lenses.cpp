// Code lenses and inlay hints: additions that the editor shows within the text.
#include <algorithm>
#include <array>

#include "cli/lsp/rule_facts.h"
#include "cli/lsp/server.h"

namespace af2::lsp {
namespace {

using dsl::Symbol;
using dsl::SymbolKind;

class LensList {
 public:
  LensList(const Session& session, const Document& document, const Analysis& analysis)
      : document_(document), analysis_(analysis), map_(session.map(document.text)) {}

  Json make() {
    const auto& symbols = analysis_.symbols.symbols();
    for (std::size_t i = 0; i < symbols.size(); ++i) {
      const Symbol& s = symbols[i];
      if (s.home != &analysis_.main() || !s.isTitle()) continue;
      if (s.kind == SymbolKind::RuleSet) addForAll(s);
      if (s.kind == SymbolKind::Rule) addForRule(s, i);
      if (s.kind == SymbolKind::Test || s.kind == SymbolKind::Property)
        add(s, "test", "af2.test", {{"titles", {s.name}}});
    }
    return std::move(list_);
  }

 private:
  void add(const Symbol& at, const std::string& title, const char* command, Json argument) {
    argument["uri"] = document_.uri;
    list_.push_back({{"range", map_.range(at.definition)},
                     {"command",
                      {{"title", title},
                       {"command", command},
                       {"arguments", Json::array({std::move(argument)})}}}});
  }

  std::size_t testCount() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(analysis_.symbols.symbols(), [&](const Symbol& s) {
          return s.home == &analysis_.main() &&
                 (s.kind == SymbolKind::Test || s.kind == SymbolKind::Property);
        }));
  }

  void addForAll(const Symbol& ruleSet) {
    add(ruleSet, "draw all", "af2.draw", Json::object());
    const std::size_t count = testCount();
    if (count > 0)
      add(ruleSet, "test all (" + std::to_string(count) + ")", "af2.test", Json::object());
  }

  void addForRule(const Symbol& rule, std::size_t id) {
    add(rule, "draw", "af2.draw", {{"rule", rule.name}});
    Json titles = Json::array();
    for (const std::size_t test : analysis_.symbols.testsOf(id))
      if (analysis_.symbols[test].home == &analysis_.main())
        titles.push_back(analysis_.symbols[test].name);
    if (titles.empty()) return;
    const std::string count = std::to_string(titles.size());
    add(rule, "test (" + count + ")", "af2.test", {{"titles", std::move(titles)}});
  }

  const Document& document_;
  const Analysis& analysis_;
  TextMap map_;
  Json list_ = Json::array();
};

std::optional<Json> codeLens(Session& session, const Json&, const Json& params) {
  const auto document = session.documentOf(params);
  const auto analysis = session.analysis(*document);
  return LensList(session, *document, *analysis).make();
}

/// The end of the last clause that makes elements.
std::optional<std::uint32_t> endOfElements(const dsl::Rule& rule) {
  std::optional<std::uint32_t> end;
  for (const dsl::Clause& clause : rule.clauses)
    if (std::holds_alternative<dsl::ElementClause>(clause.content)) end = clause.span.end;
  return end;
}

/// Shows, after the new elements of a rule, the edges that join the front.
std::optional<Json> inlayHints(Session& session, const Json&, const Json& params) {
  const auto document = session.documentOf(params);
  const auto analysis = session.analysis(*document);
  const auto rules = analysis->soundRules();
  const TextMap map = session.map(document->text);
  const dsl::Span wanted = map.span(params.at("range"));
  Json list = Json::array();
  if (!rules) return list;
  std::vector<const dsl::Rule*> seen;
  for (const dsl::CompiledRule& compiled : analysis->loaded.file->rules) {
    if (compiled.home != &analysis->main() || compiled.mirror || !compiled.text) continue;
    // Another member of the family.
    if (std::ranges::find(seen, compiled.text) != seen.end()) continue;
    seen.push_back(compiled.text);
    const auto end = endOfElements(*compiled.text);
    const AF2Rule* rule = findSound(*rules, compiled.definition.name);
    if (!end || !rule || *end < wanted.begin || *end > wanted.end) continue;
    list.push_back({{"position", map.position(*end)},
                    {"label", "new front: " + joined(factsOf(*rule).made, "none")},
                    {"paddingLeft", true}});
  }
  return list;
}

constexpr std::array kLensMethods{
    Method{"textDocument/codeLens", codeLens},
    Method{"textDocument/inlayHint", inlayHints},
};

}  // namespace

std::span<const Method> lensMethods() { return kLensMethods; }

}  // namespace af2::lsp
