#include "cli/lsp/completion_items.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "dsl/program/builtins.h"
#include "dsl/symbols/word_help.h"

namespace af2::lsp {
namespace {

namespace fs = std::filesystem;

using dsl::SymbolKind;
using Rank = ItemList::Rank;

std::string nameOnly(std::string usage) { return usage.substr(0, usage.find('(')); }

/// Names that an import or the file itself exports, if they are defined above the place.
class FileNames {
 public:
  FileNames(ItemList& list, const dsl::Module& home) : list_(list), home_(home) {}

  bool isAbove(const dsl::Module* definedIn, dsl::Span span) const {
    return definedIn != &list_.place().analysis->main() || span.end <= list_.place().offset;
  }

  void addConstants() {
    for (const auto& [name, c] : home_.constants)
      if (isAbove(c.home, c.span)) list_.add(Rank::File, ItemKind::Constant, name, "const");
  }

  void addFunctions(bool metrics) {
    for (const auto& [name, f] : home_.functions) {
      if (f.isMetric != metrics || !isAbove(f.home, f.span)) continue;
      std::string parameters;
      for (const dsl::Name& p : *f.parameters)
        parameters += (parameters.empty() ? "" : ", ") + p.text;
      list_.add(Rank::File, ItemKind::Function, name,
                std::string(metrics ? "metric " : "def ") + name + "(" + parameters + ")",
                docOf(f.home, f.span));
    }
  }

  void addTemplates() {
    for (const auto& [name, t] : home_.templates)
      list_.add(Rank::File, ItemKind::Class, name, "template", t.text->doc);
  }

 private:
  std::string docOf(const dsl::Module* home, dsl::Span span) const {
    for (const dsl::Symbol& s : list_.place().analysis->symbols.symbols())
      if (s.home == home && s.definition == span) return s.doc;
    return {};
  }

  ItemList& list_;
  const dsl::Module& home_;
};

void addBuiltins(ItemList& list) {
  for (const dsl::WordHelp& help : dsl::builtinHelp()) {
    const bool isMetric = dsl::findBuiltinMetric(help.word) != nullptr;
    const bool isMeasure = help.meaning.starts_with("Measure");
    if (isMetric && !isMeasure) continue;
    const bool isName = help.usage.find('(') == std::string_view::npos;
    list.add(Rank::Language, isName ? ItemKind::Variable : ItemKind::Function, help.word,
             std::string(help.usage), std::string(help.meaning));
  }
}

ItemKind kindOf(SymbolKind kind) {
  return kind == SymbolKind::Let || kind == SymbolKind::Parameter ? ItemKind::Variable
                                                                  : ItemKind::Field;
}

void addTitles(ItemList& list, SymbolKind kind, const dsl::Module* home) {
  const Analysis& analysis = *list.place().analysis;
  std::vector<std::string> titles;
  // The titles of a family's members are known only after compilation.
  if (kind == SymbolKind::Rule)
    for (const dsl::CompiledRule& r : analysis.loaded.file->rules)
      if (!home || r.home == home) titles.push_back(r.definition.name);
  for (const dsl::Symbol& s : analysis.symbols.symbols()) {
    const bool isThere = s.kind == kind && (!home || s.home == home);
    if (isThere && s.name.find('{') == std::string::npos) titles.push_back(s.name);
  }
  std::vector<std::string> seen;
  for (const std::string& title : titles) {
    if (std::ranges::find(seen, title) != seen.end()) continue;
    seen.push_back(title);
    list.add(Rank::File, ItemKind::Reference, title, wordFor(kind));
  }
}

void addPathsIn(ItemList& list, const fs::path& folder, const fs::path& self) {
  std::error_code error;
  for (fs::directory_iterator at(folder, error); !error && at != fs::end(at); at.increment(error)) {
    const std::string name = at->path().filename().string();
    std::error_code ignored;
    if (name.starts_with('.')) continue;
    if (at->is_directory(ignored))
      list.add(Rank::Language, ItemKind::Folder, name + "/");
    else if (at->path().extension() == ".af2" && !fs::equivalent(at->path(), self, ignored))
      list.add(Rank::File, ItemKind::File, name);
  }
}

/// Files beside the document and among the rules of AF2; for a path, the part after the last '/'.
void addPaths(ItemList& list, const std::string& typed) {
  const fs::path self = list.place().document->path;
  const std::string folder = typed.substr(0, typed.rfind('/') + 1);
  addPathsIn(list, self.parent_path() / folder, self);
  for (const fs::path& rules : list.session().surroundings().rules)
    addPathsIn(list, rules / folder, self);
  if (folder.empty()) list.add(Rank::Language, ItemKind::File, "std/quality.af2");
  if (folder == "std/") list.add(Rank::Language, ItemKind::File, "quality.af2");
}

dsl::Span typedSpan(const Place& place, const dsl::BlockContext& context) {
  dsl::Span span = context.word;
  const bool isPath = context.isInString && context.begins("import");
  if (!isPath) return span;
  const std::string_view typed =
      std::string_view(place.document->text).substr(span.begin, span.end - span.begin);
  span.begin += static_cast<std::uint32_t>(typed.rfind('/') + 1);
  return span;
}

std::string escaped(const std::string& title) {
  std::string text;
  for (const char c : title) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text;
}

}  // namespace

ItemList::ItemList(const Session& session, const Place& place, const dsl::BlockContext& context)
    : session_(session),
      place_(place),
      context_(context),
      map_(session.map(place.document->text)),
      range_(map_.range(typedSpan(place, context))) {}

Json& ItemList::add(Rank rank, ItemKind kind, const std::string& label, const std::string& detail,
                    const std::string& meaning) {
  const std::string text = context_.isInString ? escaped(label) : label;
  Json item{{"label", label},
            {"kind", static_cast<int>(kind)},
            {"sortText", std::to_string(static_cast<int>(rank)) + label},
            {"filterText", text},
            {"textEdit", {{"range", range_}, {"newText", text}}}};
  if (!detail.empty()) item["detail"] = detail;
  if (!meaning.empty()) item["documentation"] = meaning;
  items_.push_back(std::move(item));
  return items_.back();
}

void ItemList::addWords(std::span<const std::string_view> words) {
  for (const std::string_view word : words) add(Rank::Word, ItemKind::Keyword, std::string(word));
}

void ItemList::addKeywords(dsl::BlockKind block) {
  for (const std::string_view word : dsl::keywordsOf(block)) {
    const dsl::Keyword* keyword = dsl::findKeyword(block, word);
    if (!keyword) {  // a key of `meta`
      add(Rank::Word, ItemKind::Keyword, std::string(word));
      continue;
    }
    Json& item = add(Rank::Word, ItemKind::Keyword, std::string(word), std::string(keyword->form),
                     std::string(keyword->help));
    if (!session_.client.takesSnippets || keyword->snippet.empty()) continue;
    item["insertTextFormat"] = 2;
    item["textEdit"]["newText"] = keyword->snippet;
  }
}

void addVertices(ItemList& list) {
  for (const dsl::LocalName& n : list.context().names)
    if (n.kind == SymbolKind::Vertex || n.kind == SymbolKind::NewVertex ||
        n.kind == SymbolKind::TestVertex)
      list.add(Rank::Local, ItemKind::Field, n.name, wordFor(n.kind));
}

void addVerticesOfRule(ItemList& list, const std::string& title) {
  const Analysis& analysis = *list.place().analysis;
  std::vector<std::string> seen;
  for (const dsl::CompiledRule& rule : analysis.loaded.file->rules) {
    if (rule.definition.name != title) continue;
    for (const PatternVertex& v : rule.definition.vertices) {
      seen.push_back(v.name);
      list.add(Rank::Local, ItemKind::Field, v.name, "vertex");
    }
  }
  for (const dsl::Symbol& s : analysis.symbols.symbols()) {
    const bool isOfRule = s.kind == SymbolKind::Vertex && s.owner != dsl::kNoSymbol &&
                          analysis.symbols[s.owner].name == title;
    if (isOfRule && std::ranges::find(seen, s.name) == seen.end())
      list.add(Rank::Local, ItemKind::Field, s.name, "vertex");
  }
}

void addImports(ItemList& list) {
  for (const auto& [name, module] : list.place().analysis->main().imports)
    list.add(Rank::File, ItemKind::Module, name, module ? module->source.name() : "import");
}

void addTemplates(ItemList& list) {
  FileNames(list, list.place().analysis->main()).addTemplates();
  addImports(list);
}

void addMetrics(ItemList& list) {
  FileNames(list, list.place().analysis->main()).addFunctions(true);
  for (const dsl::BuiltinMetric& metric : dsl::builtinMetrics()) {
    const auto help = dsl::helpForBuiltin(metric.name);
    list.add(Rank::Language, ItemKind::Function, nameOnly(std::string(metric.usage)),
             std::string(metric.usage), help ? std::string(help->meaning) : "");
  }
  addImports(list);
}

void addExpression(ItemList& list) {
  for (const dsl::LocalName& n : list.context().names)
    list.add(Rank::Local, kindOf(n.kind), n.name, wordFor(n.kind));
  FileNames names(list, list.place().analysis->main());
  names.addConstants();
  names.addFunctions(false);
  addImports(list);
  addBuiltins(list);
  list.addWords({"and", "or", "not", "in", "if", "then", "else"});
}

void addMembers(ItemList& list, const std::string& owner) {
  const dsl::Module& main = list.place().analysis->main();
  const auto library = main.imports.find(owner);
  if (library == main.imports.end()) {
    list.add(Rank::Local, ItemKind::Field, "x", "coordinate");
    list.add(Rank::Local, ItemKind::Field, "y", "coordinate");
    return;
  }
  if (!library->second) return;
  FileNames names(list, *library->second);
  names.addConstants();
  names.addFunctions(false);
  names.addFunctions(true);
  names.addTemplates();
}

void addInString(ItemList& list) {
  const dsl::BlockContext& context = list.context();
  const Place& place = list.place();
  const std::string typed =
      place.document->text.substr(context.word.begin, context.word.end - context.word.begin);
  if (context.begins("import")) return addPaths(list, typed);
  if (context.begins("use") && context.statement.size() > 1) {
    const auto& imports = place.analysis->main().imports;
    const auto library = imports.find(context.statement[1].text);
    if (library != imports.end() && library->second)
      addTitles(list, SymbolKind::Rule, library->second);
    return;
  }
  if (context.begins("ruleset") && context.follows("extends"))
    return addTitles(list, SymbolKind::RuleSet, nullptr);
  const bool wantsRule = (context.begins("expect") && context.follows("rule")) ||
                         (context.begins("property") && context.follows("of"));
  if (wantsRule) addTitles(list, SymbolKind::Rule, nullptr);
}

}  // namespace af2::lsp
