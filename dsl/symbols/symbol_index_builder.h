// Traverses the syntax trees of rule files and records every name.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "dsl/symbols/symbol_index.h"

namespace af2::dsl {

class SymbolIndexBuilder {
 public:
  SymbolIndexBuilder(SymbolIndex& index, std::span<const std::unique_ptr<Module>> modules)
      : index_(index), modules_(modules) {}

  void build();

 private:
  using Names = std::map<std::string, std::size_t>;

  // Records the definitions of all files; this must precede the uses.
  void defineItems(const Module& module);
  void defineMirrors(const Rule& rule, const std::string& doc, const Item& item);
  void defineImport(const Import& import, const Item& item, const Module& module);
  std::size_t define(Symbol symbol);
  std::size_t defineIn(Names& names, SymbolKind kind, const Name& name, Span whole);
  Symbol itemSymbol(SymbolKind kind, const Name& name, Span whole, const std::string& doc,
                    const Item& item) const;

  // Records the uses.
  void useItem(const Item& item);
  void use(const Use& item);
  void use(const RuleSetBlock& block);
  void use(const Test& test);
  void use(const Property& property);
  void useBody(const Name& owner, const std::vector<Name>& parameters, const Expr& body,
               Span whole);
  void useRule(const Rule& rule, const Names& parameters);
  void defineVertices(const Rule& rule, Names& names);
  void use(const Instance& instance);
  template <class Content>
  void useParts(const Content& content);
  void useName(NameRole role, const Name& name, Span whole);
  void use(const Expr& expr);
  void useCall(const Expr& expr);
  void useImported(const Expr& expr);
  void useTitle(const Name& title, std::size_t user);
  void useParametersIn(const Name& title, const Names& names);
  void useLocal(const Name& name, const Names& names);
  void note(Span span, std::size_t symbol, bool isDefinition = false);

  std::size_t definedAt(const Module* home, Span span) const;
  std::size_t findRule(const Module& first, const std::string& title) const;
  std::size_t findRuleSet(const std::string& title) const;
  Span spanOfName(const Expr& expr) const;

  SymbolIndex& index_;
  std::span<const std::unique_ptr<Module>> modules_;
  const Module* module_ = nullptr;  ///< the current file
  const Item* item_ = nullptr;
  std::size_t owner_ = kNoSymbol;
  Span scope_;
  Names locals_;
  const Names* localsOfNamedRule_ = nullptr;  ///< of the rule in the previous expectation
  std::map<std::pair<const Module*, std::uint32_t>, std::size_t> byDefinition_;
  std::map<const Module*, std::map<std::string, std::size_t>> imports_;
  std::map<std::size_t, Names> localsOfRule_;  ///< by the symbol of the rule, or of its mirror
};

}  // namespace af2::dsl
