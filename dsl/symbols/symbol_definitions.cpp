// What the files define.
#include <algorithm>
#include <filesystem>

#include "dsl/symbols/symbol_index_builder.h"

namespace af2::dsl {

std::size_t SymbolIndexBuilder::define(Symbol symbol) {
  const std::size_t id = index_.symbols_.size();
  if (symbol.definition.end > symbol.definition.begin) {
    byDefinition_.emplace(std::pair(symbol.home, symbol.definition.begin), id);
    index_.occurrences_[symbol.home].push_back({symbol.definition, id, true});
  }
  index_.symbols_.push_back(std::move(symbol));
  return id;
}

std::size_t SymbolIndexBuilder::defineIn(Names& names, SymbolKind kind, const Name& name,
                                         Span whole) {
  if (const auto known = names.find(name.text); known != names.end()) {
    note(name.span, known->second);  // given twice: an error, told elsewhere
    return known->second;
  }
  Symbol symbol;
  symbol.kind = kind;
  symbol.name = name.text;
  symbol.home = module_;
  symbol.definition = name.span;
  symbol.whole = whole;
  symbol.scope = scope_;
  symbol.owner = owner_;
  symbol.item = item_;
  return names[name.text] = define(std::move(symbol));
}

Symbol SymbolIndexBuilder::itemSymbol(SymbolKind kind, const Name& name, Span whole,
                                      const std::string& doc, const Item& item) const {
  Symbol symbol;
  symbol.kind = kind;
  symbol.name = name.text;
  symbol.home = module_;
  symbol.definition = name.span;
  symbol.whole = whole;
  symbol.scope = {0, static_cast<std::uint32_t>(module_->source.text().size())};
  symbol.doc = doc;
  symbol.item = &item;
  return symbol;
}

void SymbolIndexBuilder::defineRule(const Rule& rule, const std::string& doc, const Item& item,
                                    bool isInTemplate) {
  if (!isInTemplate) define(itemSymbol(SymbolKind::Rule, rule.title, item.span, doc, item));
  for (const Clause& clause : rule.clauses) {
    const auto* mirror = std::get_if<MirrorClause>(&clause.content);
    if (!mirror || mirror->title.span.end == 0) continue;
    Symbol symbol = itemSymbol(SymbolKind::Rule, mirror->title, clause.span, doc, item);
    symbol.isMirror = true;
    define(std::move(symbol));
  }
}

void SymbolIndexBuilder::defineItems(const Module& module) {
  module_ = &module;
  for (const Item& item : module.parsed.file.items) {
    const auto add = [&](SymbolKind kind, const Name& name, const std::string& doc = {}) {
      return define(itemSymbol(kind, name, item.span, doc, item));
    };
    if (const auto* c = std::get_if<Constant>(&item.content))
      add(SymbolKind::Constant, c->name, c->doc);
    if (const auto* f = std::get_if<Function>(&item.content))
      add(SymbolKind::Function, f->name, f->doc);
    if (const auto* m = std::get_if<Metric>(&item.content))
      add(SymbolKind::Metric, m->name, m->doc);
    if (const auto* t = std::get_if<Template>(&item.content)) {
      add(SymbolKind::Template, t->name, t->doc);
      defineRule(t->rule, t->doc, item, true);
    }
    if (const auto* r = std::get_if<Rule>(&item.content)) defineRule(*r, r->doc, item, false);
    if (const auto* i = std::get_if<Instance>(&item.content))
      add(SymbolKind::Rule, i->title, i->doc);
    if (const auto* s = std::get_if<RuleSetBlock>(&item.content))
      add(SymbolKind::RuleSet, s->name, s->doc);
    if (const auto* t = std::get_if<Test>(&item.content)) add(SymbolKind::Test, t->title);
    if (const auto* p = std::get_if<Property>(&item.content)) add(SymbolKind::Property, p->title);
    if (const auto* i = std::get_if<Import>(&item.content)) {
      const std::string stem = std::filesystem::path(i->path.text).stem().string();
      const std::size_t id =
          add(SymbolKind::Import, i->alias ? *i->alias : Name{stem, i->path.span});
      const std::string& name = index_.symbols_[id].name;
      const auto target = module.imports.find(name);
      if (target != module.imports.end()) index_.symbols_[id].target = target->second;
      imports_[&module][name] = id;
    }
  }
}

/// The vertices of a rule: where its place is given, else where it is first named.
void SymbolIndexBuilder::defineVertices(const Rule& rule, Names& names) {
  for (const Clause& clause : rule.clauses)
    if (const auto* at = std::get_if<AtClause>(&clause.content))
      for (const Place& place : at->places) {
        const Span last = place.tolerance ? place.tolerance->span : place.y.span;
        defineIn(names, SymbolKind::Vertex, place.name, cover(place.name.span, last));
      }
  for (const Clause& clause : rule.clauses)
    if (const auto* front = std::get_if<FrontClause>(&clause.content))
      for (const Chain& chain : front->chains)
        for (const Name& name : chain)
          if (!names.contains(name.text)) defineIn(names, SymbolKind::Vertex, name, clause.span);
  // Every rule has a base edge, whether or not a chain names it.
  for (const char* end : {"a", "b"}) {
    if (names.contains(end)) continue;
    Symbol symbol;
    symbol.kind = SymbolKind::Vertex;
    symbol.name = end;
    symbol.home = module_;
    symbol.whole = rule.title.span;
    symbol.scope = scope_;
    symbol.owner = owner_;
    symbol.item = item_;
    names[end] = define(std::move(symbol));
  }
  for (const Clause& clause : rule.clauses) {
    if (const auto* let = std::get_if<LetClause>(&clause.content))
      for (const Definition& d : let->values)
        defineIn(names, SymbolKind::Let, d.name, cover(d.name.span, d.value.span));
    if (const auto* made = std::get_if<NewClause>(&clause.content))
      for (const Definition& d : made->vertices)
        defineIn(names, SymbolKind::NewVertex, d.name, cover(d.name.span, d.value.span));
  }
}

}  // namespace af2::dsl
