// Compiles new vertices, elements, conditions and costs, and assembles the rule.
#include "dsl/compile/clause_compiler.h"

#include <algorithm>
#include <cmath>

#include "dsl/program/compiled_forms.h"
#include "dsl/text/words.h"

namespace af2::dsl {

/// Warns if the name hides a constant, because the rule then cannot use the constant.
void ClauseCompiler::warnIfHiding(const Name& name) {
  const auto constant = home_.constants.find(name.text);
  if (mirror_ || constant == home_.constants.end()) return;
  expressions_.tell(
      Code::UnusedOrHiding, name.span, "'" + name.text + "' hides the constant of that name", "",
      "choose another name",
      {{"the constant", placeOf(constant->second.home->source, constant->second.span)}});
}

bool ClauseCompiler::defineLocal(const Name& name, Value value, LocalKind kind) {
  auto& locals = expressions_.locals;
  const auto known = locals.find(name.text);
  const bool isReplacing = known != locals.end() && known->second.kind == LocalKind::Broken;
  if (name.text == "q" || name.text == "class") {
    tell(Code::DuplicateName, name.span,
         "'" + name.text + "' is the quality level and cannot be given another meaning", "",
         "choose another name");
    return false;
  }
  if (known != locals.end() && !isReplacing) {
    std::vector<DiagnosticNote> notes;
    const bool isEnd = name.text == "a" || name.text == "b";
    if (!isEnd) notes.push_back({"first given here", placeOf(home_.source, known->second.span)});
    tell(Code::DuplicateName, name.span,
         isEnd ? "'" + name.text + "' is an end of the base edge; it is always there"
               : "'" + name.text + "' is given twice in this rule",
         "",
         isEnd ? "choose another name; the base edge a -> b needs no place and no tolerance"
               : "choose another name",
         std::move(notes));
    return false;
  }
  warnIfHiding(name);
  Local local;
  local.value = std::move(value);
  local.span = name.span;
  local.kind = kind;
  locals[name.text] = std::move(local);
  return true;
}

void ClauseCompiler::compileNew(const NewClause& clause) {
  for (const Definition& d : clause.vertices) {
    Value value = expressions_.point(d.value);
    const bool isKnown = !value.isAny();
    if (!isKnown && !isGeneric_) hasErrors_ = true;
    const auto index = static_cast<int>(matched_.size() + newPlaces_.size());
    value.vertex = isKnown ? index : -1;
    value.isNewVertex = true;
    if (isKnown) use(UsedValue::Kind::NewVertex, value, d.value.span);
    const NodePair at = isKnown ? algebra().toBase(value.at) : NodePair{};
    if (!defineLocal(d.name, value, LocalKind::NewVertex)) continue;
    newPlaces_.push_back(at);
    definition().newVertexNames.push_back(d.name.text);
    definition().newVertices.push_back(isKnown ? makeTransform(builder_, at) : nullptr);
    result_.vertexSpans.push_back(d.name.span);
  }
}

std::optional<int> ClauseCompiler::elementVertex(const Name& kind, const Name& name) {
  const auto found = matched_.find(name.text);
  if (found != matched_.end()) return stored(found->second);
  const auto& names = definition().newVertexNames;
  const auto made = std::find(names.begin(), names.end(), name.text);
  if (made != names.end())
    return static_cast<int>(matched_.size() + static_cast<std::size_t>(made - names.begin()));
  if (broken_.contains(name.text)) {
    hasErrors_ = true;
    return std::nullopt;
  }
  std::vector<std::string> known = names;
  std::string list = "a, b";
  for (const auto& [text, index] : matched_) {
    known.push_back(text);
    if (index >= 2) list += ", " + text;
  }
  for (const std::string& text : names) list += ", " + text;
  if (isNewVertexOfRule(name.text)) {
    tell(Code::UnknownName, name.span, "'" + name.text + "' is used before it is defined", "",
         "move its `new` clause up");
    return std::nullopt;
  }
  const auto local = expressions_.locals.find(name.text);
  if (local != expressions_.locals.end() && local->second.kind == LocalKind::Let) {
    local->second.isUsed = true;
    tell(Code::UnknownName, name.span, "'" + name.text + "' is a `let`, not a vertex", "",
         "make it a vertex with `new " + name.text + " = ...;`");
    return std::nullopt;
  }
  const Help help = didYouMean(name.text, known);
  if (local != expressions_.locals.end() && local->second.kind == LocalKind::Broken) {
    hasErrors_ = true;  // reported at its first use
    return std::nullopt;
  }
  markBroken(name.text);
  tell(Code::UnknownName, name.span,
       "'" + kind.text + "' uses the vertex '" + name.text + "', which this rule does not have", "",
       "vertices of this rule: " + list + (help.empty() ? "" : "; " + help));
  return std::nullopt;
}

void ClauseCompiler::addElement(const Name& kind, const std::vector<Name>& corners) {
  const Span span = cover(corners.front().span, corners.back().span);
  const std::size_t wanted = kind.text == "tri" ? 3 : kind.text == "quad" ? 4 : corners.size();
  std::vector<int> vertices;
  for (const Name& name : corners) {
    const auto vertex = elementVertex(kind, name);
    if (vertex) vertices.push_back(*vertex);
  }
  if (corners.size() != wanted)
    return tell(Code::MalformedPattern, span,
                "'" + kind.text + "' takes " + std::to_string(wanted) + " vertices",
                std::to_string(corners.size()) + " are given",
                corners.size() == 4   ? "write quad"
                : corners.size() == 3 ? "write tri"
                                      : "");
  if (corners.size() > 4)
    return tell(Code::MalformedPattern, span, "elements with more than four corners cannot be made",
                "", "split it into tri and quad elements");
  if (vertices.size() != corners.size()) return;
  if (mirror_) std::reverse(vertices.begin(), vertices.end());
  std::rotate(vertices.begin(), std::min_element(vertices.begin(), vertices.end()), vertices.end());
  RuleElement element;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    element.corners[i] = static_cast<std::int8_t>(vertices[i]);
  definition().elements.push_back(element);
  result_.elementSpans.push_back(span);
}

void ClauseCompiler::compileElements(const ElementClause& clause) {
  for (const auto& corners : clause.elements) addElement(clause.kind, corners);
}

void ClauseCompiler::compileRequire(const RequireClause& clause) {
  for (const Expr& expr : clause.conditions) {
    const Value value = expressions_.truth(expr, "the argument of `require`");
    if (value.isAny()) {
      hasErrors_ = hasErrors_ || !isGeneric_;
      continue;
    }
    const auto constant = builder_.constantValue(value.number);
    // One that never holds refuses the reference match, too (D4).
    if (constant && *constant != 0 && !mirror_ && !isGeneric_)
      expressions_.tell(Code::IdleClause, expr.span, "this condition always holds", "",
                        "it does not depend on the match");
    use(UsedValue::Kind::Requirement, value, expr.span);
    definition().requirements.push_back(makeFunction(builder_, value.number));
    result_.conditions.push_back({expr.span, {}});
    if (!constant && !isGeneric_) addCompared(expr, result_.conditions.back().compared);
  }
}

/// The values on both sides of each comparison in a condition.
void ClauseCompiler::addCompared(const Expr& condition, std::vector<ComparedValue>& compared) {
  const bool isJunction = condition.kind == ExprKind::Not || condition.kind == ExprKind::Paren ||
                          condition.name == "and" || condition.name == "or";
  const bool isComparison = condition.kind == ExprKind::Binary || condition.kind == ExprKind::In;
  if (!isJunction && !isComparison) return;
  for (const Expr& part : condition.parts) {
    if (isJunction) {
      addCompared(part, compared);
      continue;
    }
    const Value value = expressions_.evaluate(part);
    const bool isScalar = value.type == Type::Number || value.type == Type::Angle;
    if (!isScalar || builder_.constantValue(value.number)) continue;
    const std::string_view text = home_.source.text();
    compared.push_back({std::string(text.substr(part.span.begin, part.span.end - part.span.begin)),
                        value.type, makeFunction(builder_, value.number)});
  }
}

void ClauseCompiler::compileCost(const CostClause& clause) {
  const Value value = expressions_.number(clause.value, "a cost");
  hasErrors_ = hasErrors_ || (value.isAny() && !isGeneric_);
  if (value.isAny()) return;
  if (builder_.constantValue(value.number) == 0.0)
    expressions_.warnIdle(clause.value.span, "a cost of 0 changes nothing",
                          "remove it, or give it a value");
  use(UsedValue::Kind::Cost, value, clause.value.span);
  result_.costSpan = clause.value.span;
  definition().cost = makeFunction(builder_, value.number);
}

void ClauseCompiler::compilePriority(const PriorityClause& clause, Span span) {
  if (hasPriority_)
    tell(Code::DuplicateName, span, "the priority is given twice", "", "give it once");
  hasPriority_ = true;
  const auto value = expressions_.constantNumber(clause.value, "a priority");
  if (!value) return;
  if (*value != std::floor(*value) || std::abs(*value) > 1e6)
    return tell(Code::NotConstant, clause.value.span, "a priority is a whole number",
                "this is " + shownNumber(*value));
  if (*value == 0)
    expressions_.warnIdle(span, "a priority of 0 is the default",
                          "remove it, or give it another value: the smaller one wins");
  definition().priority = static_cast<int>(*value);
}

void ClauseCompiler::compileLet(const LetClause& clause) {
  for (const Definition& d : clause.values) {
    Value value = expressions_.evaluate(d.value);
    if (value.isAny() && !isGeneric_) hasErrors_ = true;
    defineLocal(d.name, std::move(value), LocalKind::Let);
  }
}

/// The cost of the rule itself; that of a mirror image may take its place.
void ClauseCompiler::compileOwnCost(const CostClause& clause, Span span) {
  if (hasCost_)
    tell(Code::DuplicateName, span, "the cost is given twice", "", "add the two up in one clause");
  hasCost_ = true;
  compileCost(clause);
}

void ClauseCompiler::compileClause(const Clause& clause) {
  match(
      clause.content, [&](const AtClause& c) { compilePlaces(c); },
      [&](const NearClause& c) { compileNear(c); },
      [&](const WeldClause& c) { compileWeld(c, clause.span); },
      [&](const FarClause& c) { compileFar(c); },
      [&](const PathClause& c) { compilePath(c, clause.span); },
      [&](const SlopeClause& c) { compileSlope(c); }, [&](const LetClause& c) { compileLet(c); },
      [&](const NewClause& c) { compileNew(c); },
      [&](const ZoneClause& c) { readZone(c, clause.span); },
      [&](const ElementClause& c) { compileElements(c); },
      [&](const RequireClause& c) { compileRequire(c); },
      [&](const CostClause& c) { compileOwnCost(c, clause.span); },
      [&](const PriorityClause& c) { compilePriority(c, clause.span); },
      [&](const MetaClause& c) {
        if (!mirror_) expressions_.checkAllowed(c);
      },
      // Chains are compiled before all other clauses; `mirror` makes another rule, see
      // RuleCompiler.
      [](const AnyOf<std::monostate, FrontClause, MirrorClause> auto&) {});
}

void ClauseCompiler::applyOverrides() {
  for (const MirrorOverride& part : mirror_->overrides) {
    for (const auto& [name, tolerance] : part.tolerances) {
      const auto found = matched_.find(name.text);
      if (found == matched_.end() || found->second < 2) {
        std::vector<std::string> known;
        for (const PatternVertex& v : definition().vertices) known.push_back(v.name);
        tell(Code::UnknownName, name.span,
             found == matched_.end()
                 ? "the rule has no vertex '" + name.text + "' with a tolerance"
                 : "'" + name.text + "' is an end of the base edge and carries no tolerance",
             "", helpAmong(name.text, known, "vertices of this rule"));
        continue;
      }
      bool isAny = false;
      const auto form = toleranceOf(tolerance, isAny);
      if (isAny && !expressions_.inChain[static_cast<std::size_t>(found->second)])
        tell(Code::MalformedPattern, tolerance.span, "'any' needs a chain",
             "'" + name.text + "' is not in a chain");
      for (PatternVertex& v : definition().vertices)
        if (v.name == name.text) v.tolerance = form;
    }
    if (part.cost) compileCost(*part.cost);
  }
}

/// Distinguishes a name that is used before its definition from a name that does not exist.
void ClauseCompiler::listNamesBelow() {
  for (const Name* name :
       namesIn(rule_, {NameRole::PlacedVertex, NameRole::Value, NameRole::NewVertex}))
    expressions_.definedBelow.emplace(name->text, name->span);
}

void ClauseCompiler::warnAboutNames() {
  if (mirror_ || hasErrors_) return;
  for (const auto& [name, local] : expressions_.locals) {
    if (local.kind != LocalKind::Let || local.isUsed) continue;
    Diagnostic unused =
        expressions_.finding(Code::UnusedOrHiding, local.span,
                             "the value '" + name + "' is never used", "", Help("remove it"));
    unused.isUnused = true;
    expressions_.tell(std::move(unused));
  }
}

/// The engine limits the number of vertices, and some loops in this file are quadratic in it.
bool ClauseCompiler::tellTooManyVertices() {
  const auto names = namesIn(rule_, {NameRole::PlacedVertex, NameRole::NewVertex});
  const std::size_t count = names.size() + 2, most = AF2Rule::kMaxVertices;
  if (count <= most) return false;
  tell(Code::MalformedPattern, names.back()->span,
       "this rule has " + std::to_string(count) + " vertices", "",
       "at most " + std::to_string(most) + " are possible, including a and b");
  return true;
}

std::optional<CompiledRule> ClauseCompiler::compile(const std::string& title, Span titleSpan) {
  result_.title = titleSpan;
  expressions_.ruleTitle = title;
  if (tellTooManyVertices()) return std::nullopt;
  definition().name = title;
  definition().source = {home_.source.name(), home_.source.lineOf(titleSpan.begin),
                         mirror_ != nullptr};
  for (int i = 0; i < 2; ++i) {
    Local end;
    end.value = algebra().vertex(i);
    end.kind = LocalKind::Vertex;
    expressions_.locals[i == 0 ? "a" : "b"] = std::move(end);
    result_.vertexSpans.push_back(titleSpan);
  }
  definition().vertices = {PatternVertex{"a", {0, 0}, std::nullopt},
                           PatternVertex{"b", {1, 0}, std::nullopt}};
  listNamesBelow();
  collectPattern();
  readLevels();
  definition().edges.push_back({0, 1, std::nullopt});
  result_.edgeSpans.push_back(titleSpan);
  for (const Clause& clause : rule_.clauses)
    if (const auto* front = std::get_if<FrontClause>(&clause.content))
      for (const Chain& chain : front->chains) addChain(chain);
  for (const Clause& clause : rule_.clauses) compileClause(clause);
  placeNearVertices();
  if (zones_.empty()) addZoneOfAct();
  compileZones();
  if (mirror_) applyOverrides();
  tellMissingValues();
  warnAboutNames();
  if (definition().zone == nullptr && zones_.empty() && !hasErrors_)
    tell(Code::MissingZone, titleSpan, "this rule has no zone",
         "only a zone prevents its elements from overlapping others",
         "say which region must be empty: `zone a, b, ...;`");
  const bool isWhole = definition().zone && !hasErrors_ && !isGeneric_ &&
                       std::all_of(definition().newVertices.begin(), definition().newVertices.end(),
                                   [](const auto& t) { return t != nullptr; });
  if (!isWhole) return std::nullopt;
  return std::move(result_);
}

}  // namespace af2::dsl
