// Where names are used.
#include <algorithm>
#include <set>

#include "dsl/program/builtins.h"
#include "dsl/symbols/symbol_index_builder.h"

namespace af2::dsl {

void SymbolIndexBuilder::note(Span span, std::size_t symbol, bool isDefinition) {
  if (symbol == kNoSymbol || span.end <= span.begin) return;
  index_.occurrences_[module_].push_back({span, symbol, isDefinition});
}

std::size_t SymbolIndexBuilder::definedAt(const Module* home, Span span) const {
  const auto found = byDefinition_.find({home, span.begin});
  return found == byDefinition_.end() ? kNoSymbol : found->second;
}

/// Rules of the file itself first; a title that is written out before one with {parameters}.
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
  if (definition == name.span) return;  // noted where it was defined
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

void SymbolIndexBuilder::use(const Tolerance& tolerance) {
  if (!tolerance.any) use(tolerance.form);
}

void SymbolIndexBuilder::use(const LevelRange& levels) {
  use(levels.first);
  use(levels.last);
}

void SymbolIndexBuilder::useMirror(const MirrorClause& mirror) {
  useParametersIn(mirror.title, locals_);
  for (const MirrorOverride& part : mirror.overrides) {
    for (const MirrorOverride::Vertex& vertex : part.tolerances) {
      useVertex(vertex.name);
      use(vertex.tolerance);
    }
    if (part.levels) use(*part.levels);
    if (part.cost) use(part.cost->value);
  }
}

void SymbolIndexBuilder::useClause(const Clause& clause) {
  const auto values = [&](const std::vector<Expr>& list) {
    for (const Expr& expr : list) use(expr);
  };
  const auto definitions = [&](const std::vector<Definition>& list) {
    for (const Definition& d : list) use(d.value);
  };
  std::visit(
      [&](const auto& c) {
        using Content = std::decay_t<decltype(c)>;
        if constexpr (std::is_same_v<Content, FrontClause>) {
          for (const Chain& chain : c.chains)
            for (const Name& name : chain) useVertex(name);
        } else if constexpr (std::is_same_v<Content, AtClause>) {
          for (const Place& place : c.places) {
            use(place.x);
            use(place.y);
            if (place.tolerance) use(*place.tolerance);
          }
        } else if constexpr (std::is_same_v<Content, SlopeClause>) {
          useVertex(c.from);
          useVertex(c.to);
          use(c.tolerance);
        } else if constexpr (std::is_same_v<Content, LetClause>) {
          definitions(c.values);
        } else if constexpr (std::is_same_v<Content, NewClause>) {
          definitions(c.vertices);
        } else if constexpr (std::is_same_v<Content, ZoneClause>) {
          values(c.corners);
          use(c.when);
        } else if constexpr (std::is_same_v<Content, ElementClause>) {
          for (const auto& element : c.elements)
            for (const Name& name : element) useVertex(name);
        } else if constexpr (std::is_same_v<Content, RequireClause>) {
          values(c.conditions);
        } else if constexpr (std::is_same_v<Content, CostClause> ||
                             std::is_same_v<Content, PriorityClause>) {
          use(c.value);
        } else if constexpr (std::is_same_v<Content, MirrorClause>) {
          useMirror(c);
        }
      },
      clause.content);
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
  use(rule.levels);
  defineVertices(rule, locals_);
  for (const Clause& clause : rule.clauses) useClause(clause);
  localsOfRule_[owner_] = locals_;
  for (const Clause& clause : rule.clauses)
    if (const auto* mirror = std::get_if<MirrorClause>(&clause.content))
      localsOfRule_[definedAt(module_, mirror->title.span)] = locals_;
}

void SymbolIndexBuilder::useBody(const Name& owner, const std::vector<Name>& parameters,
                                 const Expr& body, Span whole) {
  owner_ = definedAt(module_, owner.span);
  scope_ = whole;
  for (const Name& name : parameters) defineIn(locals_, SymbolKind::Parameter, name, name.span);
  use(body);
}

void SymbolIndexBuilder::use(const Import&) {}

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
  for (const Setting& setting : block.settings) {
    std::visit(
        [&](const auto& s) {
          using Content = std::decay_t<decltype(s)>;
          if constexpr (std::is_same_v<Content, MatchSetting> ||
                        std::is_same_v<Content, FadeSetting>)
            use(s.value);
          else if constexpr (std::is_same_v<Content, ScoreSetting>)
            use(s.metric);
          else if constexpr (std::is_same_v<Content, AcceptSetting>)
            use(s.condition);
          else if constexpr (std::is_same_v<Content, OrderSetting>)
            for (const Expr& key : s.keys) use(key);
          else if constexpr (std::is_same_v<Content, ClassesSetting>)
            use(s.first), use(s.last);
        },
        setting.content);
  }
}

void SymbolIndexBuilder::use(const Expectation& expectation, std::size_t test) {
  if (const auto* rule = std::get_if<ExpectRule>(&expectation.outcome)) {
    useTitle(rule->title, test);
    const auto inRule = localsOfRule_.find(findRule(*module_, rule->title.text));
    for (const auto& [vertex, inTest] : rule->bindings) {
      if (inRule != localsOfRule_.end()) useLocal(vertex, inRule->second);
      useVertex(inTest);
    }
    for (const Name& name : rule->reasonVertices) useVertex(name);
  }
  if (const auto* made = std::get_if<ExpectNew>(&expectation.outcome)) use(made->x), use(made->y);
  if (const auto* front = std::get_if<ExpectFront>(&expectation.outcome))
    for (const auto& chain : front->chains)
      for (const ExpectedVertex& vertex : chain)
        if (vertex.newIndex == 0) useVertex(vertex.name);
  if (const auto* score = std::get_if<ExpectScore>(&expectation.outcome)) use(score->value);
  if (const auto* c = std::get_if<ExpectCondition>(&expectation.outcome)) use(c->condition);
}

void SymbolIndexBuilder::use(const Test& test) {
  owner_ = definedAt(module_, test.title.span);
  scope_ = test.span;
  const auto place = [&](const TestVertex& v) {
    if (!v.isPlaced) return useVertex(v.name);
    defineIn(locals_, SymbolKind::TestVertex, v.name, cover(v.name.span, v.y.span));
    use(v.x);
    use(v.y);
  };
  for (const TestClause& clause : test.clauses) {
    if (const auto* front = std::get_if<TestFront>(&clause.content))
      for (const TestChain& chain : front->chains) std::ranges::for_each(chain, place);
    if (const auto* points = std::get_if<TestPoints>(&clause.content))
      std::ranges::for_each(points->points, place);
    if (const auto* base = std::get_if<TestBase>(&clause.content))
      useVertex(base->from), useVertex(base->to);
    if (const auto* level = std::get_if<TestLevel>(&clause.content)) use(level->value);
    if (const auto* size = std::get_if<TestSize>(&clause.content)) use(size->value);
    if (const auto* expectation = std::get_if<Expectation>(&clause.content))
      use(*expectation, owner_);
  }
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

void SymbolIndexBuilder::useItem(const Item& item) {
  item_ = &item;
  owner_ = kNoSymbol;
  locals_.clear();
  std::visit(
      [&](const auto& c) {
        using Content = std::decay_t<decltype(c)>;
        if constexpr (std::is_same_v<Content, Constant>) {
          use(c.value);
        } else if constexpr (std::is_same_v<Content, Function> || std::is_same_v<Content, Metric>) {
          useBody(c.name, c.parameters, c.value, item.span);
        } else if constexpr (std::is_same_v<Content, Rule>) {
          owner_ = definedAt(module_, c.title.span);
          useRule(c, {});
        } else if constexpr (std::is_same_v<Content, Template>) {
          owner_ = definedAt(module_, c.name.span);
          scope_ = item.span;
          for (const Name& name : c.parameters)
            defineIn(locals_, SymbolKind::Parameter, name, name.span);
          useRule(c.rule, Names(locals_));
        } else if constexpr (std::is_same_v<Content, Instance>) {
          if (c.call.qualifier.empty()) {
            const auto t = module_->templates.find(c.call.name);
            if (t != module_->templates.end())
              note(spanOfName(c.call), definedAt(t->second.home, t->second.span));
          } else {
            useImported(c.call);
          }
          for (const Expr& part : c.call.parts) use(part);
        } else if constexpr (!std::is_same_v<Content, std::monostate>) {
          use(c);
        }
      },
      item.content);
}

void SymbolIndexBuilder::build() {
  for (const auto& module : modules_) defineItems(*module);
  // Tests and properties speak of the vertices of rules, wherever those stand.
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
