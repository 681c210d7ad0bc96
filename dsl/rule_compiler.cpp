#include "dsl/rule_compiler.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <set>

#include "dsl/compiled_forms.h"
#include "dsl/shape_program.h"
#include "dsl/words.h"
#include "engine/error.h"

namespace af2::dsl {
namespace {

/// Compiles the clauses of one rule, as written or for its mirror image.
class ClauseCompiler {
 public:
  ClauseCompiler(CompileContext& context, const Module& home, const SharedSettings& settings,
                 const Rule& rule, const MirrorClause* mirror)
      : home_(home),
        settings_(settings),
        rule_(rule),
        mirror_(mirror),
        expressions_(context, home, ExpressionPlace::Rule,
                     Algebra(builder_, {countPlaces(rule) + 2, mirror != nullptr})) {
    expressions_.fade = [this] { return fadeNode(); };
    result_.text = &rule;
    result_.home = &home;
    result_.isMirror = mirror != nullptr;
  }

  ExpressionCompiler& expressions() { return expressions_; }

  void define(const std::string& name, const RuleCompiler::Parameter& parameter) {
    Local local;
    local.value = valueOf(parameter.value);
    local.span = parameter.span;
    local.kind = LocalKind::Parameter;
    expressions_.locals[name] = std::move(local);
    isGeneric_ = isGeneric_ || parameter.value.type == Type::Any;
  }

  /// Nothing if something was told that leaves no rule.
  std::optional<CompiledRule> compile(const std::string& title, Span titleSpan);

 private:
  static int countPlaces(const Rule& rule) {
    int count = 0;
    for (const Clause& clause : rule.clauses)
      if (const auto* at = std::get_if<AtClause>(&clause.content))
        count += static_cast<int>(at->places.size());
    return count;
  }

  const Algebra& algebra() const { return expressions_.algebra(); }
  RuleDefinition& definition() { return result_.definition; }
  int stored(int vertex) const { return algebra().frame().stored(vertex); }

  Value valueOf(const ConstantName& c) const {
    switch (c.type) {
      case Type::Number:
        return algebra().number(c.number);
      case Type::Angle:
        return algebra().angle(c.number);
      case Type::Truth:
        return algebra().truth(c.number != 0);
      case Type::Geometric:
        return algebra().vector({builder_.constant(c.x), builder_.constant(c.y)});
      default:
        return {};
    }
  }

  Node fadeNode() {
    if (fade_ >= 0) return fade_;
    const Node q = builder_.make(Op::Level, std::initializer_list<Node>{});
    fade_ = builder_.divide(builder_.constant(1), q);
    if (settings_.fadeExpression) {
      DiagnosticList silent;  // told once, with the rule set
      Registry none;
      CompileContext quiet{silent, none};
      ExpressionCompiler compiler(quiet, *settings_.fadeHome, ExpressionPlace::Level,
                                  Algebra(builder_, {}));
      const Value value = compiler.evaluate(*settings_.fadeExpression);
      if (value.type == Type::Number) fade_ = value.number;
    }
    return fade_;
  }

  template <class... Arguments>
  void tell(const char* code, Span span, std::string message, Arguments&&... arguments) {
    expressions_.tell(code, span, std::move(message), std::forward<Arguments>(arguments)...);
    hasErrors_ = true;
  }

  void warn(const char* code, Span span, std::string message, std::string help) {
    expressions_.tell(code, span, std::move(message), "", std::move(help), Severity::Warning);
  }

  void markBroken(const std::string& name) {
    broken_.insert(name);
    Local local;
    local.kind = LocalKind::Broken;
    expressions_.locals.emplace(name, std::move(local));
  }
  bool defineLocal(const Name& name, Value value, LocalKind kind);
  void poisonBrokenNames();
  void collectPattern();
  void readLevels();
  void compileClause(const Clause& clause);
  void compilePlaces(const AtClause& at);
  std::optional<ToleranceForm> toleranceOf(const Tolerance& tolerance, bool& isAny);
  std::optional<ToleranceForm> formOf(const Expr& expr);
  void addChain(const Chain& chain);
  void addEdge(const Name& from, const Name& to);
  std::optional<int> matchedVertex(const Name& name, const char* use);
  void compileSlope(const SlopeClause& slope);
  void compileNew(const NewClause& clause);
  void compileElements(const ElementClause& clause);
  void addElement(const Name& kind, const std::vector<Name>& corners);
  std::optional<int> elementVertex(const Name& kind, const Name& name);
  void compileZones();
  void compileRequire(const RequireClause& clause);
  void compileCost(const CostClause& clause);
  void compilePriority(const PriorityClause& clause, Span span);
  void applyOverrides();
  void warnAboutNames();
  /// A zone clause, evaluated where it stands: everything is defined above its use.
  struct ReadZone {
    const ZoneClause* text = nullptr;
    std::vector<ExpressionCompiler::Corner> corners;  ///< of a list
    Value shape;                                      ///< of a shape
    Value when;
    bool isRight = false;
  };

  void readZone(const ZoneClause& clause, Span span);
  std::shared_ptr<const AF2FreeZoneDef> cornerZone(const ReadZone& zone);
  ShapeValue shapeOf(const ReadZone& zone);
  void compileUserZone(const ReadZone& zone);
  void listNamesBelow();
  static ShapeValue unionOf(std::vector<ShapeValue> shapes);
  bool isShapeClause(const ZoneClause& clause) { return clause.corners.size() == 1; }

  const Module& home_;
  const SharedSettings& settings_;
  const Rule& rule_;
  const MirrorClause* mirror_;
  ProgramBuilder mutable builder_;
  ExpressionCompiler expressions_;
  CompiledRule result_;
  std::map<std::string, int> matched_;
  std::vector<ReadZone> zones_;
  std::map<std::string, bool> atDefined_;
  std::vector<NodePair> newPlaces_;
  std::set<std::string> broken_;
  Node fade_ = -1;
  bool hasErrors_ = false;
  bool isGeneric_ = false;
  bool hasCost_ = false, hasPriority_ = false;
};

bool ClauseCompiler::defineLocal(const Name& name, Value value, LocalKind kind) {
  auto& locals = expressions_.locals;
  const auto known = locals.find(name.text);
  const bool isReplacing = known != locals.end() && known->second.kind == LocalKind::Broken;
  if (name.text == "q" || name.text == "class") {
    tell("R2", name.span,
         "'" + name.text + "' is the quality level and cannot be given another meaning", "",
         "choose another name");
    return false;
  }
  if (known != locals.end() && !isReplacing) {
    std::vector<DiagnosticNote> notes;
    const bool isEnd = name.text == "a" || name.text == "b";
    if (!isEnd) notes.push_back({"first given here", placeOf(home_.source, known->second.span)});
    tell("R2", name.span,
         isEnd ? "'" + name.text + "' is an end of the base edge; it is always there"
               : "'" + name.text + "' is given twice in this rule",
         "",
         isEnd ? "choose another name; the base edge a -> b needs no place and no tolerance"
               : "choose another name",
         Severity::Error, std::move(notes));
    return false;
  }
  if (home_.constants.contains(name.text) && !mirror_)
    expressions_.tell("A2", name.span, "'" + name.text + "' hides the constant of that name", "",
                      "choose another name", Severity::Warning,
                      {{"the constant", placeOf(home_.constants.at(name.text).home->source,
                                                home_.constants.at(name.text).span)}});
  Local local;
  local.value = std::move(value);
  local.span = name.span;
  local.kind = kind;
  locals[name.text] = std::move(local);
  return true;
}

void ClauseCompiler::poisonBrokenNames() {
  for (const BrokenStretch& stretch : home_.parsed.broken) {
    if (stretch.span.begin < rule_.span.begin || stretch.span.end > rule_.span.end) continue;
    hasErrors_ = true;
    for (const std::string& name : stretch.names) {
      if (name == "a" || name == "b" || isBuiltin(name)) continue;
      broken_.insert(name);
      Local local;
      local.kind = LocalKind::Broken;
      expressions_.locals.emplace(name, std::move(local));
    }
  }
}

/// First the vertices of all `at` clauses and the chains, so that every expression knows which
/// vertices have a place on the front.
void ClauseCompiler::collectPattern() {
  matched_ = {{"a", 0}, {"b", 1}};
  int next = 2;
  for (const Clause& clause : rule_.clauses)
    if (const auto* at = std::get_if<AtClause>(&clause.content))
      for (const Place& place : at->places)
        if (matched_.emplace(place.name.text, next).second) ++next;
  expressions_.inChain.assign(static_cast<std::size_t>(next), false);
  expressions_.inChain[0] = expressions_.inChain[1] = true;
  for (const Clause& clause : rule_.clauses)
    if (const auto* front = std::get_if<FrontClause>(&clause.content))
      for (const Chain& chain : front->chains)
        for (const Name& name : chain)
          if (const auto found = matched_.find(name.text); found != matched_.end())
            expressions_.inChain[static_cast<std::size_t>(found->second)] = true;
}

void ClauseCompiler::readLevels() {
  const LevelRange* levels = &rule_.levels;
  if (mirror_)
    for (const MirrorOverride& part : mirror_->overrides)
      if (part.levels) levels = &*part.levels;
  const auto whole = [&](const Expr& expr) -> std::optional<int> {
    const auto value = expressions_.constantNumber(expr, "a quality level");
    if (!value) return std::nullopt;
    if (*value >= 1 && *value <= 1e6 && *value == std::floor(*value))
      return static_cast<int>(*value);
    tell("Y3", expr.span, "a quality level is a whole number from 1",
         "this is " + shownNumber(*value), "1 is the best");
    return std::nullopt;
  };
  result_.levelSpan = levels->first.span;
  const auto first = whole(levels->first);
  if (first) definition().firstLevel = *first;
  if (levels->last.isMissing()) return;
  result_.levelSpan = cover(levels->first.span, levels->last.span);
  const auto last = whole(levels->last);
  definition().lastLevel = last;
  if (first && last && *last < *first) {
    tell("D2", result_.levelSpan, "no quality level lies in this range",
         "its end lies below its beginning", "write the smaller level first");
    definition().lastLevel = std::nullopt;
  }
}

std::optional<ToleranceForm> ClauseCompiler::formOf(const Expr& expr) {
  const bool isForm = expr.kind == ExprKind::Tuple && expr.parts.size() == 3;
  if (!isForm) {
    const auto weight = expressions_.constantNumber(expr, "a tolerance");
    if (!weight) return std::nullopt;
    if (*weight < 0) {
      tell("Y3", expr.span, "a tolerance's weight cannot be negative", "",
           "a larger weight is stricter; 0 or `any` lets all through");
      return std::nullopt;
    }
    return ToleranceForm{*weight, 0, *weight};
  }
  const auto xx = expressions_.constantNumber(expr.parts[0], "a coefficient"),
             xy = expressions_.constantNumber(expr.parts[1], "a coefficient"),
             yy = expressions_.constantNumber(expr.parts[2], "a coefficient");
  if (!xx || !xy || !yy) return std::nullopt;
  if (*xx < 0 || *yy < 0 || *xy * *xy > 4 * *xx * *yy) {
    tell("Y3", expr.span, "this form is negative for some deviations", "",
         "a form (xx, xy, yy) needs xx >= 0, yy >= 0 and xy^2 <= 4 xx yy");
    return std::nullopt;
  }
  return ToleranceForm{*xx, mirror_ ? -*xy : *xy, *yy};
}

std::optional<ToleranceForm> ClauseCompiler::toleranceOf(const Tolerance& tolerance, bool& isAny) {
  isAny = tolerance.any;
  if (tolerance.any) return std::nullopt;
  const auto form = formOf(tolerance.form);
  hasErrors_ = hasErrors_ || !form;
  return form ? form : ToleranceForm{};
}

void ClauseCompiler::compilePlaces(const AtClause& at) {
  for (const Place& place : at.places) {
    const auto x = expressions_.constantNumber(place.x, "a reference coordinate");
    const auto y = expressions_.constantNumber(place.y, "a reference coordinate");
    hasErrors_ = hasErrors_ || !x || !y;
    const auto index = static_cast<int>(definition().vertices.size());
    if (!defineLocal(place.name, algebra().vertex(index), LocalKind::Vertex)) continue;
    PatternVertex vertex;
    vertex.name = place.name.text;
    if (x && y) vertex.reference = {mirror_ ? 1 - *x : *x, *y};
    if (place.tolerance) {
      bool isAny = false;
      vertex.tolerance = toleranceOf(*place.tolerance, isAny);
      const bool isInChain =
          expressions_.inChain[static_cast<std::size_t>(matched_.at(place.name.text))];
      if (isAny && !isInChain)
        tell("T2", place.tolerance->span, "'any' needs a chain",
             "'" + place.name.text + "' stands in no chain",
             "name the vertex in a `front` chain that leads to it, or give a tolerance");
    }
    definition().vertices.push_back(std::move(vertex));
    result_.vertexSpans.push_back(place.name.span);
  }
}

std::optional<int> ClauseCompiler::matchedVertex(const Name& name, const char* use) {
  const auto found = matched_.find(name.text);
  if (found != matched_.end()) return found->second;
  if (broken_.contains(name.text)) return std::nullopt;
  for (const Clause& clause : rule_.clauses)
    if (const auto* made = std::get_if<NewClause>(&clause.content))
      for (const Definition& d : made->vertices)
        if (d.name.text == name.text) {
          tell("T2", name.span,
               "'" + name.text + "' is a new vertex; the front does not have it yet", "",
               std::string(use) + " names matched vertices only");
          return std::nullopt;
        }
  std::vector<std::string> known;
  for (const auto& [text, index] : matched_) known.push_back(text);
  std::string help = didYouMean(name.text, known);
  tell("R1", name.span, "the vertex '" + name.text + "' has no place", "",
       help.empty() ? "say where it is expected: `at " + name.text + " (x, y);`" : help);
  markBroken(name.text);
  return std::nullopt;
}

void ClauseCompiler::addEdge(const Name& fromName, const Name& toName) {
  const auto from = matchedVertex(fromName, "a chain"), to = matchedVertex(toName, "a chain");
  if (!from || !to) return;
  const Span span = cover(fromName.span, toName.span);
  if (*from == *to) return tell("T2", span, "an edge from a vertex to itself");
  int u = stored(*from), v = stored(*to);
  if (mirror_) std::swap(u, v);
  for (std::size_t i = 0; i < definition().edges.size(); ++i) {
    const PatternEdge& known = definition().edges[i];
    const std::string text = fromName.text + " -> " + toName.text;
    const bool isBase = i == 0;
    if (known.from == u && known.to == v) {
      if (isBase && result_.edgeSpans[0] == result_.title) {
        result_.edgeSpans[0] = span;
        return;
      }
      return tell("T2", span, "the edge " + text + " is named twice", "",
                  "name each front edge once");
    }
    if (known.from == v && known.to == u)
      return tell("T2", span, "the edge " + text + " runs against another one of the pattern", "",
                  "front edges have the unmeshed region on their left");
    if (known.from == u || known.to == v) {
      const Name& at = (known.from == u) != (mirror_ != nullptr) ? fromName : toName;
      return tell("T2", span, "the chains branch at '" + at.text + "'",
                  isBase ? "the base edge a -> b is always part of the pattern" : "",
                  "each vertex has one front edge that comes and one that goes");
    }
  }
  definition().edges.push_back({u, v, std::nullopt});
  result_.edgeSpans.push_back(span);
}

void ClauseCompiler::addChain(const Chain& chain) {
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) addEdge(chain[i], chain[i + 1]);
}

void ClauseCompiler::compileSlope(const SlopeClause& slope) {
  const auto from = matchedVertex(slope.from, "slope"), to = matchedVertex(slope.to, "slope");
  bool isAny = false;
  const auto form = toleranceOf(slope.tolerance, isAny);
  if (!from || !to) return;
  int u = stored(*from), v = stored(*to);
  if (mirror_) std::swap(u, v);
  for (PatternEdge& edge : definition().edges)
    if (edge.from == u && edge.to == v) {
      if (edge.slope && !isAny)
        tell("R2", cover(slope.from.span, slope.to.span), "the slope of this edge is given twice",
             "", "give it once");
      edge.slope = form;
      if (u == 0 && v == 1 && !mirror_)
        warn("D1", cover(slope.from.span, slope.tolerance.span),
             "a slope of the base edge tests its length only: the frame's x axis runs along it",
             "remove the clause if that is not meant");
      return;
    }
  tell("T2", cover(slope.from.span, slope.to.span),
       slope.from.text + " -> " + slope.to.text + " is no edge of the pattern", "",
       "name it in a `front` chain; a slope is a tolerance on a front edge");
}

void ClauseCompiler::compileNew(const NewClause& clause) {
  for (const Definition& d : clause.vertices) {
    Value value = expressions_.point(d.value, "a new vertex");
    const bool isKnown = !value.isAny();
    if (!isKnown && !isGeneric_) hasErrors_ = true;
    const auto index = static_cast<int>(matched_.size() + newPlaces_.size());
    value.vertex = isKnown ? index : -1;
    value.isNewVertex = true;
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
  for (const Clause& clause : rule_.clauses)
    if (const auto* later = std::get_if<NewClause>(&clause.content))
      for (const Definition& d : later->vertices)
        if (d.name.text == name.text) {
          tell("R1", name.span, "'" + name.text + "' is used before it is defined", "",
               "move its `new` clause up");
          return std::nullopt;
        }
  const auto local = expressions_.locals.find(name.text);
  if (local != expressions_.locals.end() && local->second.kind == LocalKind::Let) {
    local->second.isUsed = true;
    tell("R1", name.span, "'" + name.text + "' is a `let`, no vertex", "",
         "make it a vertex with `new " + name.text + " = ...;`");
    return std::nullopt;
  }
  const std::string help = didYouMean(name.text, known);
  if (local != expressions_.locals.end() && local->second.kind == LocalKind::Broken) {
    hasErrors_ = true;  // told where it was first used
    return std::nullopt;
  }
  markBroken(name.text);
  tell("R1", name.span,
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
    return tell("T2", span, "'" + kind.text + "' takes " + std::to_string(wanted) + " vertices",
                std::to_string(corners.size()) + " are given",
                corners.size() == 4   ? "write quad"
                : corners.size() == 3 ? "write tri"
                                      : "");
  if (corners.size() > 4)
    return tell("T2", span, "elements with more than four corners cannot be made", "",
                "split it into tri and quad elements");
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
    const Value value = expressions_.truth(expr, "what is required");
    if (value.isAny()) {
      hasErrors_ = hasErrors_ || !isGeneric_;
      continue;
    }
    const auto constant = builder_.constantValue(value.number);
    if (constant && !mirror_ && !isGeneric_)
      expressions_.tell("D1", expr.span,
                        *constant != 0 ? "this condition always holds"
                                       : "this condition never holds, so the rule never applies",
                        "", "it does not depend on the match", Severity::Warning);
    definition().requirements.push_back(makeFunction(builder_, value.number));
  }
}

void ClauseCompiler::compileCost(const CostClause& clause) {
  const Value value = expressions_.number(clause.value, "a cost");
  hasErrors_ = hasErrors_ || (value.isAny() && !isGeneric_);
  if (value.isAny()) return;
  definition().cost = makeFunction(builder_, value.number);
}

void ClauseCompiler::compilePriority(const PriorityClause& clause, Span span) {
  if (hasPriority_) tell("R2", span, "the priority is given twice", "", "give it once");
  hasPriority_ = true;
  const auto value = expressions_.constantNumber(clause.value, "a priority");
  if (!value) return;
  if (*value != std::floor(*value) || std::abs(*value) > 1e6)
    return tell("Y3", clause.value.span, "a priority is a whole number",
                "this is " + shownNumber(*value));
  definition().priority = static_cast<int>(*value);
}

void ClauseCompiler::compileClause(const Clause& clause) {
  std::visit(
      [&](const auto& content) {
        using Content = std::decay_t<decltype(content)>;
        if constexpr (std::is_same_v<Content, AtClause>) {
          compilePlaces(content);
        } else if constexpr (std::is_same_v<Content, LetClause>) {
          for (const Definition& d : content.values) {
            Value value = expressions_.evaluate(d.value);
            if (value.isAny() && !isGeneric_) hasErrors_ = true;
            defineLocal(d.name, std::move(value), LocalKind::Let);
          }
        } else if constexpr (std::is_same_v<Content, NewClause>) {
          compileNew(content);
        } else if constexpr (std::is_same_v<Content, ZoneClause>) {
          readZone(content, clause.span);
        } else if constexpr (std::is_same_v<Content, ElementClause>) {
          compileElements(content);
        } else if constexpr (std::is_same_v<Content, RequireClause>) {
          compileRequire(content);
        } else if constexpr (std::is_same_v<Content, CostClause>) {
          if (hasCost_)
            tell("R2", clause.span, "the cost is given twice", "", "add the two up in one clause");
          hasCost_ = true;
          compileCost(content);
        } else if constexpr (std::is_same_v<Content, PriorityClause>) {
          compilePriority(content, clause.span);
        }
      },
      clause.content);
}

void ClauseCompiler::applyOverrides() {
  for (const MirrorOverride& part : mirror_->overrides) {
    for (const auto& [name, tolerance] : part.tolerances) {
      const auto found = matched_.find(name.text);
      if (found == matched_.end() || found->second < 2) {
        std::vector<std::string> known;
        for (const PatternVertex& v : definition().vertices) known.push_back(v.name);
        tell("R1", name.span,
             found == matched_.end()
                 ? "the rule has no vertex '" + name.text + "' with a tolerance"
                 : "'" + name.text + "' is an end of the base edge and carries no tolerance",
             "", didYouMean(name.text, known));
        continue;
      }
      bool isAny = false;
      const auto form = toleranceOf(tolerance, isAny);
      if (isAny && !expressions_.inChain[static_cast<std::size_t>(found->second)])
        tell("T2", tolerance.span, "'any' needs a chain", "'" + name.text + "' stands in no chain");
      for (PatternVertex& v : definition().vertices)
        if (v.name == name.text) v.tolerance = form;
    }
    if (part.cost) compileCost(*part.cost);
  }
}

void ClauseCompiler::readZone(const ZoneClause& clause, Span span) {
  ReadZone zone;
  zone.text = &clause;
  zone.isRight = clause.corners.size() != 2;
  if (!zone.isRight) tell("Y6", span, "a zone needs at least three corners", "2 are given");
  if (isShapeClause(clause)) {
    zone.shape = expressions_.shape(clause.corners[0]);
    zone.isRight = !zone.shape.isAny();
  } else {
    for (const Expr& expr : clause.corners) {
      auto corner = expressions_.corner(expr);
      const bool isBroken =
          corner.preferred.isAny() || (corner.limiting && corner.limiting->isAny());
      zone.isRight = zone.isRight && !isBroken;
      zone.corners.push_back(std::move(corner));
    }
  }
  if (!clause.when.isMissing()) {
    zone.when = expressions_.truth(clause.when, "what follows `when`");
    zone.isRight = zone.isRight && !zone.when.isAny();
  }
  hasErrors_ = hasErrors_ || !zone.isRight;
  zones_.push_back(std::move(zone));
  result_.zoneSpans.push_back(span);
}

/// The list form of a zone, in the engine's fast form.
std::shared_ptr<const AF2FreeZoneDef> ClauseCompiler::cornerZone(const ReadZone& zone) {
  std::vector<ConvexPolygonZoneDef::Corner> corners;
  for (const auto& corner : zone.corners) {
    ConvexPolygonZoneDef::Corner made;
    made.preferred = makeTransform(builder_, algebra().toBase(corner.preferred.at));
    if (corner.limiting)
      made.limiting = makeTransform(builder_, algebra().toBase(corner.limiting->at));
    corners.push_back(std::move(made));
  }
  if (mirror_) {
    std::reverse(corners.begin(), corners.end());
    std::rotate(corners.begin(), corners.end() - 2, corners.end());  // a, b come first again
  }
  return std::make_shared<ConvexPolygonZoneDef>(std::move(corners), settings_.fade);
}

ShapeValue ClauseCompiler::shapeOf(const ReadZone& zone) {
  if (isShapeClause(*zone.text)) return reflected(algebra(), *zone.shape.shape);
  ShapeValue result;
  result.kind = ShapeKind::Convex;
  for (const auto& corner : zone.corners)
    result.points.push_back(
        corner.limiting ? algebra().lerp(corner.limiting->at, corner.preferred.at, fadeNode())
                        : corner.preferred.at);
  return reflected(algebra(), result);
}

void ClauseCompiler::compileUserZone(const ReadZone& zone) {
  const Span span = zone.text->corners[0].span;
  if (zones_.size() > 1 || !zone.text->when.isMissing())
    return tell("Y7", span, "a registered shape can only be the whole zone");
  if (mirror_)
    return tell("Y7", span, "a rule with a registered zone shape cannot be mirrored", "",
                "write the mirror image as a rule of its own");
  definition().zone = std::make_shared<UserZoneDef>(zone.shape.shape->user,
                                                    builder_.program(zone.shape.shape->numbers));
}

ShapeValue ClauseCompiler::unionOf(std::vector<ShapeValue> shapes) {
  ShapeValue result = std::move(shapes[0]);
  for (std::size_t i = 1; i < shapes.size(); ++i) {
    ShapeValue both;
    both.kind = ShapeKind::Union;
    both.parts = {std::make_shared<const ShapeValue>(std::move(result)),
                  std::make_shared<const ShapeValue>(std::move(shapes[i]))};
    result = std::move(both);
  }
  return result;
}

void ClauseCompiler::compileZones() {
  if (zones_.empty()) return;
  const auto hasWhen = [](const ReadZone& z) { return !z.text->when.isMissing(); };
  const bool hasConditions = std::any_of(zones_.begin(), zones_.end(), hasWhen);
  for (std::size_t i = 1; i < zones_.size(); ++i)
    if (hasConditions && !hasWhen(zones_[i - 1]))
      expressions_.tell("D1", result_.zoneSpans[i], "this zone is never used", "",
                        "the one without `when` takes all that is left; write it last",
                        Severity::Warning);
  if (!std::all_of(zones_.begin(), zones_.end(), [](const ReadZone& z) { return z.isRight; }))
    return;
  for (const ReadZone& zone : zones_)
    if (isShapeClause(*zone.text) && zone.shape.shape->user) return compileUserZone(zone);
  if (zones_.size() == 1 && !hasConditions && !isShapeClause(*zones_[0].text)) {
    definition().zone = cornerZone(zones_[0]);
    return;
  }
  const auto program = [&](const ShapeValue& shape) {
    return std::make_shared<const ShapeProgram>(builder_, shape);
  };
  std::vector<ShapeZoneDef::Alternative> alternatives;
  std::vector<ShapeValue> united;
  for (const ReadZone& zone : zones_) {
    if (!hasConditions)
      united.push_back(shapeOf(zone));
    else
      alternatives.push_back({hasWhen(zone) ? makeFunction(builder_, zone.when.number) : nullptr,
                              program(shapeOf(zone))});
  }
  if (!united.empty()) alternatives.push_back({nullptr, program(unionOf(std::move(united)))});
  definition().zone = std::make_shared<ShapeZoneDef>(std::move(alternatives));
}

/// So that a name used too early is told apart from one that there is not.
void ClauseCompiler::listNamesBelow() {
  for (const Clause& clause : rule_.clauses) {
    if (const auto* at = std::get_if<AtClause>(&clause.content))
      for (const Place& p : at->places) expressions_.definedBelow.emplace(p.name.text, p.name.span);
    if (const auto* let = std::get_if<LetClause>(&clause.content))
      for (const Definition& d : let->values)
        expressions_.definedBelow.emplace(d.name.text, d.name.span);
    if (const auto* made = std::get_if<NewClause>(&clause.content))
      for (const Definition& d : made->vertices)
        expressions_.definedBelow.emplace(d.name.text, d.name.span);
  }
}

void ClauseCompiler::warnAboutNames() {
  if (mirror_ || hasErrors_) return;
  for (const auto& [name, local] : expressions_.locals)
    if (local.kind == LocalKind::Let && !local.isUsed)
      warn("A2", local.span, "the value '" + name + "' is never used", "remove it");
}

std::optional<CompiledRule> ClauseCompiler::compile(const std::string& title, Span titleSpan) {
  result_.title = titleSpan;
  expressions_.ruleTitle = title;
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
  poisonBrokenNames();
  listNamesBelow();
  collectPattern();
  readLevels();
  definition().edges.push_back({0, 1, std::nullopt});
  result_.edgeSpans.push_back(titleSpan);
  for (const Clause& clause : rule_.clauses)
    if (const auto* front = std::get_if<FrontClause>(&clause.content))
      for (const Chain& chain : front->chains) addChain(chain);
  for (const Clause& clause : rule_.clauses)
    if (const auto* slope = std::get_if<SlopeClause>(&clause.content)) compileSlope(*slope);
  for (const Clause& clause : rule_.clauses) compileClause(clause);
  compileZones();
  if (mirror_) applyOverrides();
  warnAboutNames();
  if (definition().zone == nullptr && zones_.empty() && !hasErrors_)
    tell("Z6", titleSpan, "this rule has no zone",
         "nothing would keep its elements from lying over others",
         "say which region must be empty: `zone a, b, ...;`");
  const bool isWhole = definition().zone && !hasErrors_ && !isGeneric_ &&
                       std::all_of(definition().newVertices.begin(), definition().newVertices.end(),
                                   [](const auto& t) { return t != nullptr; });
  if (!isWhole) return std::nullopt;
  return std::move(result_);
}

}  // namespace

std::string shownNumber(double value) {
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value);
  return std::string(text, end.ptr);
}

std::string filledTitle(ExpressionCompiler& expressions, const Name& title) {
  std::string result;
  for (std::size_t i = 0; i < title.text.size(); ++i) {
    const std::size_t close = title.text[i] == '{' ? title.text.find('}', i) : std::string::npos;
    if (close == std::string::npos) {
      result += title.text[i];
      continue;
    }
    const std::string name = title.text.substr(i + 1, close - i - 1);
    i = close;
    const auto local = expressions.locals.find(name);
    const bool isParameter =
        local != expressions.locals.end() && local->second.kind == LocalKind::Parameter;
    const Value value = isParameter ? local->second.value : Value{};
    const auto number = value.isAny() || value.type == Type::Geometric || value.type == Type::Shape
                            ? std::nullopt
                            : expressions.builder().constantValue(value.number);
    if (number) {
      result += shownNumber(value.type == Type::Angle ? *number * 180 / std::numbers::pi : *number);
    } else if (!isParameter) {
      std::vector<std::string> known;
      for (const auto& [text, l] : expressions.locals)
        if (l.kind == LocalKind::Parameter) known.push_back(text);
      const std::string help = didYouMean(name, known);
      expressions.tell("R1", title.span,
                       "the title asks for '{" + name + "}', which is no parameter of this rule",
                       "",
                       help.empty() ? "parameters come from `for (...)` or from a template" : help);
    }
  }
  return result;
}

/// The exact mirror image of a sound rule, whether it asks for one or not.
std::shared_ptr<const RuleDefinition> RuleCompiler::imageOf(
    const Rule& rule, const std::map<std::string, Parameter>& parameters) {
  DiagnosticList silent;
  CompileContext quiet{silent, context_.registry};
  const MirrorClause plain;
  ClauseCompiler compiler(quiet, home_, settings_, rule, &plain);
  for (const auto& [name, parameter] : parameters) compiler.define(name, parameter);
  auto compiled = compiler.compile(rule.title.text, rule.title.span);
  if (!compiled) return nullptr;
  return std::make_shared<const RuleDefinition>(std::move(compiled->definition));
}

void RuleCompiler::compileOne(const Rule& rule, const std::map<std::string, Parameter>& parameters,
                              const InstanceTitle& title, std::vector<CompiledRule>& result) {
  std::vector<const MirrorClause*> mirrors{nullptr};
  std::vector<Span> mirrorSpans{{}};
  for (const Clause& clause : rule.clauses)
    if (const auto* mirror = std::get_if<MirrorClause>(&clause.content)) {
      mirrors.push_back(mirror);
      mirrorSpans.push_back(clause.span);
    }
  for (std::size_t i = 0; i < mirrors.size(); ++i) {
    ClauseCompiler compiler(context_, home_, settings_, rule, mirrors[i]);
    for (const auto& [name, parameter] : parameters) compiler.define(name, parameter);
    const InstanceTitle ownTitle = i == 0 ? title : InstanceTitle{mirrors[i]->title, &home_};
    const std::string filled = filledTitle(compiler.expressions(), ownTitle.title);
    const Span titleSpan = ownTitle.home == &home_ ? ownTitle.title.span : rule.title.span;
    auto compiled = compiler.compile(filled, titleSpan);
    if (i > 1)
      compiler.expressions().tell("R2", mirrorSpans[i], "a rule has one mirror image", "",
                                  "remove this clause");
    if (!compiled) continue;
    compiled->doc = rule.doc;
    compiled->titlePlace = placeOf(ownTitle.home->source, ownTitle.title.span);
    if (ownTitle.home != &home_)
      compiled->definition.source = {ownTitle.home->source.name(), compiled->titlePlace.line,
                                     false};
    compiled->parameters = parameters;
    compiled->mirror = mirrors[i];
    if (!mirrors[i]) compiled->image = imageOf(rule, parameters);
    if (mirrors.size() > 1) compiled->mirrorSpan = mirrorSpans[std::max<std::size_t>(1, i)];
    result.push_back(std::move(*compiled));
  }
}

std::vector<CompiledRule> RuleCompiler::compile(const Rule& rule,
                                                const std::map<std::string, Parameter>& parameters,
                                                const InstanceTitle* instance) {
  std::vector<CompiledRule> result;
  const InstanceTitle ownTitle = instance ? *instance : InstanceTitle{rule.title, &home_};
  if (!rule.family) {
    compileOne(rule, parameters, ownTitle, result);
    return result;
  }
  ProgramBuilder builder;
  ExpressionCompiler values(context_, home_, ExpressionPlace::Constant, Algebra(builder, {}));
  std::set<std::string> names;
  for (const Name& name : rule.family->names)
    if (!names.insert(name.text).second || parameters.contains(name.text))
      values.tell("R2", name.span, "the parameter '" + name.text + "' is given twice", "",
                  "choose another name");
  for (const Expr& tuple : rule.family->tuples) {
    const bool isTuple = tuple.kind == ExprKind::Tuple || tuple.kind == ExprKind::Paren;
    const std::span<const Expr> parts =
        isTuple ? std::span<const Expr>(tuple.parts) : std::span<const Expr>(&tuple, 1);
    if (parts.size() != rule.family->names.size()) {
      values.tell("Y6", tuple.span,
                  "this gives " + std::to_string(parts.size()) + " values for " +
                      std::to_string(rule.family->names.size()) + " parameters",
                  "", "give one value for each parameter");
      continue;
    }
    std::map<std::string, Parameter> all = parameters;
    bool isRight = true;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Value value = values.evaluate(parts[i]);
      const bool isScalar = value.type == Type::Number || value.type == Type::Angle;
      const auto constant = isScalar ? values.builder().constantValue(value.number) : std::nullopt;
      if (!constant) {
        isRight = false;
        if (!value.isAny())
          values.tell("Y1", parts[i].span, "a family's value must be a number or an angle",
                      "this is " + describe(value));
        continue;
      }
      Parameter p;
      p.value.type = value.type;
      p.value.number = *constant;
      p.span = rule.family->names[i].span;
      all[rule.family->names[i].text] = p;
    }
    if (isRight) compileOne(rule, all, ownTitle, result);
  }
  return result;
}

std::optional<CompiledProperty> RuleCompiler::compileProperty(const Property& property,
                                                              const Module& written,
                                                              const CompiledRule& rule) {
  ClauseCompiler compiler(context_, *rule.home, settings_, *rule.text, rule.mirror);
  for (const auto& [name, parameter] : rule.parameters) compiler.define(name, parameter);
  if (!compiler.compile(rule.definition.name, rule.title)) return std::nullopt;
  ExpressionCompiler& expressions = compiler.expressions();
  expressions.readIn(written);
  expressions.ruleTitle.clear();
  CompiledProperty result;
  result.title = property.title.text;
  result.span = property.title.span;
  result.rule = rule.definition.name;
  result.firstLevel = result.lastLevel = rule.definition.firstLevel;
  bool isRight = true;
  if (property.variable) {
    const auto first = expressions.constantNumber(property.first, "the first level");
    const auto last = expressions.constantNumber(property.last, "the last level");
    const bool isRange = first && last && *first >= 1 && *first <= *last &&
                         *last <= settings_.maxLevel && *first == std::floor(*first) &&
                         *last == std::floor(*last);
    isRight = isRange;
    if (first && last && !isRange)
      expressions.tell(
          "Y3", cover(property.first.span, property.last.span),
          "the levels must be whole numbers from 1 to " + std::to_string(settings_.maxLevel));
    if (isRange) {
      result.firstLevel = static_cast<int>(*first);
      result.lastLevel = static_cast<int>(*last);
    }
    Local level;
    level.kind = LocalKind::Parameter;
    level.value = expressions.algebra().scalar(
        Type::Number, expressions.builder().make(Op::Level, std::initializer_list<Node>{}));
    expressions.locals[property.variable->text] = level;
  }
  for (const Expr& expr : property.expectations) {
    const Value value = expressions.truth(expr, "what is expected");
    isRight = isRight && !value.isAny();
    if (value.isAny()) continue;
    result.expectations.push_back(makeFunction(expressions.builder(), value.number));
    result.expectationSpans.push_back(expr.span);
  }
  if (!isRight) return std::nullopt;
  return result;
}

}  // namespace af2::dsl
