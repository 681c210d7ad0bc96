// Collects the uses of names.
#include <algorithm>
#include <set>

#include "dsl/program/builtins.h"
#include "dsl/symbols/symbol_index_builder.h"
#include "dsl/syntax/names.h"

namespace af2::dsl {

void SymbolIndexBuilder::note(Span span, std::size_t symbol, bool isDefinition) {
  if (symbol == kNoSymbol || span.end <= span.begin) return;
  index_.occurrences_[module_].push_back({span, symbol, isDefinition});
}

std::size_t SymbolIndexBuilder::definedAt(const Module* home, Span span) const {
  const auto found = byDefinition_.find({home, span.begin});
  return found == byDefinition_.end() ? kNoSymbol : found->second;
}

/// Rules of the file itself come first, and a plain title precedes a title with {parameters}.
std::size_t SymbolIndexBuilder::findRule(const Module& first, const std::string& title) const {
  std::size_t best = kNoSymbol;
  int bestRank = 4;
  for (std::size_t i = 0; i < index_.symbols_.size(); ++i) {
    const Symbol& s = index_.symbols_[i];
    if (s.kind != SymbolKind::Rule) continue;
    const bool isExact = s.name == title;
    if (!isExact && !isTitleOf(s.name, title)) continue;
    const int rank = (s.home == &first ? 0 : 2) + (isExact ? 0 : 1);
    if (rank < bestRank) best = i, bestRank = rank;
  }
  return best;
}

std::size_t SymbolIndexBuilder::findRuleSet(const std::string& title) const {
  for (std::size_t i = 0; i < index_.symbols_.size(); ++i) {
    const Symbol& s = index_.symbols_[i];
    if (s.kind == SymbolKind::RuleSet && s.name == title) return i;
  }
  return kNoSymbol;
}

void SymbolIndexBuilder::useTitle(const Name& title, std::size_t user) {
  const std::size_t rule = findRule(*module_, title.text);
  note(title.span, rule);
  if (rule == kNoSymbol || user == kNoSymbol) return;
  std::vector<std::size_t>& tests = index_.testsOf_[rule];
  if (tests.empty() || tests.back() != user) tests.push_back(user);
}

/// {k} in a title.
void SymbolIndexBuilder::useParametersIn(const Name& title, const Names& names) {
  if (title.span.end <= title.span.begin) return;
  const std::string_view text =
      module_->source.text().substr(title.span.begin, title.span.end - title.span.begin);
  for (std::size_t open = text.find('{'); open != std::string_view::npos;
       open = text.find('{', open + 1)) {
    const std::size_t close = text.find('}', open);
    if (close == std::string_view::npos) return;
    const auto found = names.find(std::string(text.substr(open + 1, close - open - 1)));
    const auto begin = title.span.begin + static_cast<std::uint32_t>(open) + 1;
    const auto end = title.span.begin + static_cast<std::uint32_t>(close);
    if (found != names.end()) note({begin, end}, found->second);
  }
}

void SymbolIndexBuilder::useLocal(const Name& name, const Names& names) {
  const auto found = names.find(name.text);
  if (found == names.end()) return;
  const Span definition = index_.symbols_[found->second].definition;
  if (definition == name.span) return;  // recorded at its definition
  note(name.span, found->second);
}

/// The name in `lib.name`, `lib.name(...)` and `name(...)`.
Span SymbolIndexBuilder::spanOfName(const Expr& expr) const {
  const auto length = static_cast<std::uint32_t>(expr.name.size());
  if (expr.qualifier.empty()) return {expr.span.begin, expr.span.begin + length};
  const std::string_view text = module_->source.text();
  std::size_t at = expr.span.begin + expr.qualifier.size();
  while (at < expr.span.end && text.substr(at, length) != expr.name) ++at;
  const auto begin = static_cast<std::uint32_t>(at);
  return {begin, std::min(begin + length, expr.span.end)};
}

void SymbolIndexBuilder::useImported(const Expr& expr) {
  const auto length = static_cast<std::uint32_t>(expr.qualifier.size());
  const auto& imports = imports_[module_];
  if (const auto found = imports.find(expr.qualifier); found != imports.end())
    note({expr.span.begin, expr.span.begin + length}, found->second);
  const auto library = module_->imports.find(expr.qualifier);
  if (library == module_->imports.end() || !library->second) return;
  const Module& home = *library->second;
  const Span span = spanOfName(expr);
  if (const auto c = home.constants.find(expr.name); c != home.constants.end())
    note(span, definedAt(c->second.home, c->second.span));
  else if (const auto f = home.functions.find(expr.name); f != home.functions.end())
    note(span, definedAt(f->second.home, f->second.span));
  else if (const auto t = home.templates.find(expr.name); t != home.templates.end())
    note(span, definedAt(t->second.home, t->second.span));
}

void SymbolIndexBuilder::useCall(const Expr& expr) {
  if (!expr.qualifier.empty()) return useImported(expr);
  if (const auto f = module_->functions.find(expr.name); f != module_->functions.end())
    note(spanOfName(expr), definedAt(f->second.home, f->second.span));
}

void SymbolIndexBuilder::use(const Expr& expr) {
  if (expr.kind == ExprKind::Name) {
    const auto local = locals_.find(expr.name);
    const auto constant = module_->constants.find(expr.name);
    if (local != locals_.end())
      note(expr.span, local->second);
    else if (constant != module_->constants.end())
      note(expr.span, definedAt(constant->second.home, constant->second.span));
    else
      useCall(expr);  // a metric named without its weights
  }
  if (expr.kind == ExprKind::Imported) useImported(expr);
  if (expr.kind == ExprKind::Call) useCall(expr);
  for (const Expr& part : expr.parts) use(part);
}

void SymbolIndexBuilder::useName(NameRole role, const Name& name, Span whole) {
  switch (role) {
    case NameRole::Vertex:
    case NameRole::ChainVertex:
      return useLocal(name, locals_);
    case NameRole::PlacedVertex:
    case NameRole::NewVertex:
    case NameRole::Value:
      return;  // already defined, before the clauses of the rule are visited
    case NameRole::TestVertex:
      defineIn(locals_, SymbolKind::TestVertex, name, whole);
      return;
    case NameRole::MirrorTitle:
      return useParametersIn(name, locals_);
    case NameRole::RuleTitle: {
      useTitle(name, owner_);
      const auto locals = localsOfRule_.find(findRule(*module_, name.text));
      localsOfNamedRule_ = locals == localsOfRule_.end() ? nullptr : &locals->second;
      return;
    }
    case NameRole::RuleVertex:
      if (localsOfNamedRule_) useLocal(name, *localsOfNamedRule_);
      return;
  }
}

template <class Content>
void SymbolIndexBuilder::useParts(const Content& content) {
  visitParts(content, Overloaded{[this](const Expr& expr) { use(expr); },
                                 [this](NameRole role, const Name& name, Span whole = {}) {
                                   useName(role, name, whole);
                                 }});
}

void SymbolIndexBuilder::useRule(const Rule& rule, const Names& parameters) {
  locals_ = parameters;
  scope_ = rule.span;
  if (rule.family) {
    for (const Expr& tuple : rule.family->tuples) use(tuple);
    for (const Name& name : rule.family->names)
      defineIn(locals_, SymbolKind::Parameter, name, name.span);
  }
  useParametersIn(rule.title, locals_);
  use(rule.levels.first);
  use(rule.levels.last);
  defineVertices(rule, locals_);
  for (const Clause& clause : rule.clauses) useParts(clause.content);
  localsOfRule_[owner_] = locals_;
  for (const Name* mirror : namesIn(rule, {NameRole::MirrorTitle}))
    localsOfRule_[definedAt(module_, mirror->span)] = locals_;
}

void SymbolIndexBuilder::useBody(const Name& owner, const std::vector<Name>& parameters,
                                 const Expr& body, Span whole) {
  owner_ = definedAt(module_, owner.span);
  scope_ = whole;
  for (const Name& name : parameters) defineIn(locals_, SymbolKind::Parameter, name, name.span);
  use(body);
}

void SymbolIndexBuilder::use(const Use& item) {
  const auto& imports = imports_[module_];
  if (const auto found = imports.find(item.library.text); found != imports.end())
    note(item.library.span, found->second);
  const auto library = module_->imports.find(item.library.text);
  if (library == module_->imports.end() || !library->second) return;
  const auto title = [&](const Name& name) {
    note(name.span, findRule(*library->second, name.text));
  };
  if (item.rule) title(*item.rule);
  for (const Name& name : item.except) title(name);
}

void SymbolIndexBuilder::use(const RuleSetBlock& block) {
  if (block.base) note(block.base->span, findRuleSet(block.base->text));
  for (const Setting& setting : block.settings) useParts(setting.content);
}

void SymbolIndexBuilder::use(const Test& test) {
  owner_ = definedAt(module_, test.title.span);
  scope_ = test.span;
  for (const TestClause& clause : test.clauses) useParts(clause.content);
}

void SymbolIndexBuilder::use(const Property& property) {
  owner_ = definedAt(module_, property.title.span);
  scope_ = item_->span;
  useTitle(property.rule, owner_);
  use(property.first);
  use(property.last);
  const auto inRule = localsOfRule_.find(findRule(*module_, property.rule.text));
  if (inRule != localsOfRule_.end()) locals_ = inRule->second;
  if (property.variable) {
    locals_.erase(property.variable->text);
    defineIn(locals_, SymbolKind::Parameter, *property.variable, property.variable->span);
  }
  for (const Expr& expr : property.expectations) use(expr);
}

void SymbolIndexBuilder::use(const Instance& instance) {
  const Expr& call = instance.call;
  const auto found = module_->templates.find(call.name);
  if (!call.qualifier.empty())
    useImported(call);
  else if (found != module_->templates.end())
    note(spanOfName(call), definedAt(found->second.home, found->second.span));
  for (const Expr& part : call.parts) use(part);
}

void SymbolIndexBuilder::useItem(const Item& item) {
  item_ = &item;
  owner_ = kNoSymbol;
  locals_.clear();
  match(
      item.content, [&](const Constant& c) { use(c.value); },
      [&](const AnyOf<Function, Metric> auto& c) {
        useBody(c.name, c.parameters, c.value, item.span);
      },
      [&](const Rule& c) {
        owner_ = definedAt(module_, c.title.span);
        useRule(c, {});
      },
      [&](const Template& c) {
        owner_ = definedAt(module_, c.name.span);
        scope_ = item.span;
        for (const Name& name : c.parameters)
          defineIn(locals_, SymbolKind::Parameter, name, name.span);
        useRule(c.rule, Names(locals_));
      },
      [&](const AnyOf<Use, RuleSetBlock, Instance, Test, Property> auto& c) { use(c); },
      [](const AnyOf<std::monostate, Import, Extern> auto&) {});
}

void SymbolIndexBuilder::build() {
  for (const auto& module : modules_) defineItems(*module);
  // Tests and properties mention vertices of rules, which may be anywhere in the file.
  for (const bool isTest : {false, true})
    for (const auto& module : modules_) {
      module_ = module.get();
      for (const Item& item : module->parsed.file.items) {
        const bool speaksOfRules = std::holds_alternative<Test>(item.content) ||
                                   std::holds_alternative<Property>(item.content);
        if (speaksOfRules == isTest) useItem(item);
      }
    }
  for (auto& [module, list] : index_.occurrences_)
    std::ranges::stable_sort(list, {}, [](const Occurrence& o) { return o.span.begin; });
}

SymbolIndex::SymbolIndex(std::span<const std::unique_ptr<Module>> modules) {
  SymbolIndexBuilder(*this, modules).build();
}

}  // namespace af2::dsl
