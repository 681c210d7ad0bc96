// Collects the definitions of the files.
#include <algorithm>
#include <filesystem>

#include "dsl/symbols/symbol_index_builder.h"
#include "dsl/syntax/names.h"

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
    note(name.span, known->second);  // defined twice: an error that is reported elsewhere
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

void SymbolIndexBuilder::defineMirrors(const Rule& rule, const std::string& doc, const Item& item) {
  for (const Clause& clause : rule.clauses)
    visitNames(clause.content, [&](NameRole role, const Name& title, Span) {
      if (role != NameRole::MirrorTitle || title.span.end == 0) return;
      Symbol symbol = itemSymbol(SymbolKind::Rule, title, clause.span, doc, item);
      symbol.isMirror = true;
      define(std::move(symbol));
    });
}

void SymbolIndexBuilder::defineImport(const Import& import, const Item& item,
                                      const Module& module) {
  const std::string stem = std::filesystem::path(import.path.text).stem().string();
  const Name name = import.alias ? *import.alias : Name{stem, import.path.span};
  const std::size_t id = define(itemSymbol(SymbolKind::Import, name, item.span, {}, item));
  const auto target = module.imports.find(name.text);
  if (target != module.imports.end()) index_.symbols_[id].target = target->second;
  imports_[&module][name.text] = id;
}

void SymbolIndexBuilder::defineItems(const Module& module) {
  module_ = &module;
  for (const Item& item : module.parsed.file.items) {
    const auto add = [&](SymbolKind kind, const Name& name, const std::string& doc = {}) {
      define(itemSymbol(kind, name, item.span, doc, item));
    };
    match(
        item.content, [&](const Import& c) { defineImport(c, item, module); },
        [&](const Constant& c) { add(SymbolKind::Constant, c.name, c.doc); },
        [&](const Function& c) { add(SymbolKind::Function, c.name, c.doc); },
        [&](const Metric& c) { add(SymbolKind::Metric, c.name, c.doc); },
        [&](const Extern& c) {
          const bool isMetric = c.kind.text == "metric";
          add(isMetric ? SymbolKind::Metric : SymbolKind::Function, c.name, c.doc);
        },
        [&](const RuleSetBlock& c) { add(SymbolKind::RuleSet, c.name, c.doc); },
        [&](const Rule& c) {
          add(SymbolKind::Rule, c.title, c.doc);
          defineMirrors(c, c.doc, item);
        },
        [&](const Template& c) {
          add(SymbolKind::Template, c.name, c.doc);
          defineMirrors(c.rule, c.doc, item);
        },
        [&](const Instance& c) { add(SymbolKind::Rule, c.title, c.doc); },
        [&](const Test& c) { add(SymbolKind::Test, c.title); },
        [&](const Property& c) { add(SymbolKind::Property, c.title); },
        [](const AnyOf<std::monostate, Use> auto&) {});
  }
}

/// The vertices of a rule: a vertex is defined where its position is given, otherwise where it is
/// first named.
void SymbolIndexBuilder::defineVertices(const Rule& rule, Names& names) {
  const auto forEachName = [&](const auto& visit) {
    for (const Clause& clause : rule.clauses)
      visitNames(clause.content, [&](NameRole role, const Name& name, Span whole) {
        visit(role, name, role == NameRole::ChainVertex ? clause.span : whole);
      });
  };
  forEachName([&](NameRole role, const Name& name, Span whole) {
    if (role == NameRole::PlacedVertex) defineIn(names, SymbolKind::Vertex, name, whole);
  });
  forEachName([&](NameRole role, const Name& name, Span whole) {
    if (role == NameRole::ChainVertex && !names.contains(name.text))
      defineIn(names, SymbolKind::Vertex, name, whole);
  });
  // Every rule has a base edge, even if no chain names it.
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
  forEachName([&](NameRole role, const Name& name, Span whole) {
    if (role == NameRole::Value) defineIn(names, SymbolKind::Let, name, whole);
    if (role == NameRole::NewVertex) defineIn(names, SymbolKind::NewVertex, name, whole);
  });
}

}  // namespace af2::dsl
