// Compiles the pattern of a rule: levels, positions, tolerances, chains.
#include "dsl/compile/clause_compiler.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "dsl/program/builtins.h"
#include "dsl/program/compiled_forms.h"
#include "dsl/text/words.h"
#include "engine/rule/rule_at_match.h"

namespace af2::dsl {
namespace {

/// In target sizes; a longer reach would make each step search a large part of the front.
constexpr double kLongestReach = 5;

/// The number for a level; the last one also applies to all higher levels.
double valueAt(const std::vector<double>& byLevel, std::size_t index) {
  return byLevel[std::min(index, byLevel.size() - 1)];
}

}  // namespace

void ClauseCompiler::poisonBrokenNames() {
  for (const BrokenStretch& stretch : home_.parsed.broken) {
    if (stretch.span.begin < rule_.span.begin || stretch.span.end > rule_.span.end) continue;
    hasErrors_ = true;
    for (const std::string& name : stretch.names) {
      if (name == "a" || name == "b") continue;
      broken_.insert(name);
      Local local;
      local.kind = LocalKind::Broken;
      expressions_.locals.emplace(name, std::move(local));
    }
  }
}

/// Collects the vertices of all `at` clauses and chains first, because every expression must know
/// which vertices are on the front.
void ClauseCompiler::collectPattern() {
  matched_ = {{"a", 0}, {"b", 1}};
  int next = 2;
  for (const Name* name : namesIn(rule_, {NameRole::PlacedVertex}))
    if (matched_.emplace(name->text, next).second) ++next;
  expressions_.inChain.assign(static_cast<std::size_t>(next), false);
  expressions_.inChain[0] = expressions_.inChain[1] = true;
  const auto haveOnePlace = [&](const auto& names) {
    for (const Name* name : names)
      if (const auto found = matched_.find(name->text); found != matched_.end())
        expressions_.inChain[static_cast<std::size_t>(found->second)] = true;
  };
  haveOnePlace(namesIn(rule_, {NameRole::ChainVertex}));
  for (const Clause& clause : rule_.clauses)
    if (const auto* near = std::get_if<NearClause>(&clause.content))
      for (const NearClause::Vertex& vertex : near->vertices)
        haveOnePlace(std::array{&vertex.name});
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
    const bool isDifference = expr.kind == ExprKind::Binary && expr.name == "-";
    tell(Code::NotConstant, expr.span, "a quality level is a whole number from 1",
         "this is " + shownNumber(*value),
         isDifference ? "a range of levels is written 1..3" : "1 is the best");
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
    tell(Code::UnreachedLevels, result_.levelSpan, "no quality level lies in this range",
         "its end is less than its beginning", "write the smaller level first",
         std::vector<DiagnosticNote>(), Severity::Error);
    definition().lastLevel = std::nullopt;
  }
}

/// The last level at which the rule is tried.
int ClauseCompiler::lastLevel() const {
  const RuleDefinition& rule = result_.definition;
  return std::max(rule.firstLevel,
                  std::min(rule.lastLevel.value_or(settings_.maxLevel), settings_.maxLevel));
}

/// The values by level from 1 on, or one value for all levels; nothing after an error. Levels below
/// the rule's first level have the value of that level.
std::optional<std::vector<double>> ClauseCompiler::numberByLevel(const Expr& expr,
                                                                 const std::string& what) {
  if (expr.isMissing()) return std::nullopt;
  const Value value = expressions_.number(expr, what);
  if (value.isAny()) return std::nullopt;
  if (const auto constant = builder_.constantValue(value.number)) return std::vector{*constant};
  if (builder_.dependsOnMatch(value.number)) {
    tell(Code::NotConstant, expr.span, what + " cannot depend on the match", "",
         "use numbers, constants, parameters and q; write other conditions on a match as "
         "`require`");
    return std::nullopt;
  }
  const int first = definition().firstLevel;
  std::vector<double> numbers;
  const ExpressionFunction function(builder_.program(std::array<Node, 1>{value.number}));
  for (int level = 1; level <= lastLevel(); ++level) {
    const auto at = function.evaluate({{}, std::max(level, first), nullptr});
    if (!at) {
      tell(Code::NoValue, expr.span, what + " has no value at level " + std::to_string(level), "",
           "a division by zero, a root of a negative number or the like");
      return std::nullopt;
    }
    numbers.push_back(*at);
  }
  return numbers;
}

std::optional<ToleranceByLevel> ClauseCompiler::formOf(const Expr& expr) {
  const bool isForm = expr.kind == ExprKind::Tuple && expr.parts.size() == 3;
  if (expr.kind == ExprKind::Tuple && !isForm) {
    for (const Expr& part : expr.parts) numberByLevel(part, "a coefficient");
    tell(Code::ArgumentCount, expr.span, "a form has three coefficients, (xx, xy, yy)",
         std::to_string(expr.parts.size()) + " are given",
         "write `~ w` for the same weight in all directions, or `~ (xx, xy, yy)`");
    return std::nullopt;
  }
  std::array<std::vector<double>, 3> weights{{{0}, {0}, {0}}};
  bool isRight = true;
  for (std::size_t i = 0; i < (isForm ? 3 : 1); ++i) {
    auto numbers =
        isForm ? numberByLevel(expr.parts[i], "a coefficient") : numberByLevel(expr, "a tolerance");
    isRight = isRight && numbers;
    if (numbers) weights[i] = std::move(*numbers);
  }
  if (!isRight) return std::nullopt;
  if (!isForm) weights[2] = weights[0];
  const std::size_t levels = std::max({weights[0].size(), weights[1].size(), weights[2].size()});
  std::vector<ToleranceForm> forms;
  for (std::size_t i = 0; i < levels; ++i) {
    const ToleranceForm form{valueAt(weights[0], i), valueAt(weights[1], i),
                             valueAt(weights[2], i)};
    if (form.xx < 0 || form.yy < 0 || form.xy * form.xy > 4 * form.xx * form.yy) {
      const std::string where = levels > 1 ? " at level " + std::to_string(i + 1) : "";
      if (isForm)
        tell(Code::NotConstant, expr.span, "this form is negative for some deviations" + where, "",
             "a form (xx, xy, yy) needs xx >= 0, yy >= 0 and xy^2 <= 4 xx yy");
      else
        tell(Code::NotConstant, expr.span, "a tolerance's weight cannot be negative",
             where.empty() ? "" : "it is " + shownNumber(form.xx) + where,
             "a larger weight is stricter; 0 or `any` accepts every position");
      return std::nullopt;
    }
    forms.push_back({form.xx, mirror_ ? 0 - form.xy : form.xy, form.yy});
  }
  return ToleranceByLevel(std::move(forms));
}

std::optional<ToleranceByLevel> ClauseCompiler::toleranceOf(const Tolerance& tolerance,
                                                            bool& isAny) {
  isAny = tolerance.any;
  if (tolerance.any) return std::nullopt;
  const auto form = formOf(tolerance.form);
  hasErrors_ = hasErrors_ || !form;
  return form ? form : ToleranceForm{};
}

std::optional<ReferenceByLevel> ClauseCompiler::referenceOf(const Place& place) {
  const auto x = numberByLevel(place.x, "a reference coordinate");
  const auto y = numberByLevel(place.y, "a reference coordinate");
  if (!x || !y) return std::nullopt;
  std::vector<Point2> points;
  for (std::size_t i = 0; i < std::max(x->size(), y->size()); ++i) {
    const Point2 p{valueAt(*x, i), valueAt(*y, i)};
    points.push_back({mirror_ ? 1 - p.x : p.x, p.y});
  }
  return ReferenceByLevel(std::move(points));
}

void ClauseCompiler::compilePlaces(const AtClause& at) {
  for (const Place& place : at.places) {
    const auto reference = referenceOf(place);
    hasErrors_ = hasErrors_ || !reference;
    const auto index = static_cast<int>(definition().vertices.size());
    if (!defineLocal(place.name, algebra().vertex(index), LocalKind::Vertex)) continue;
    PatternVertex vertex;
    vertex.name = place.name.text;
    if (reference) vertex.reference = *reference;
    if (place.tolerance) {
      bool isAny = false;
      vertex.tolerance = toleranceOf(*place.tolerance, isAny);
      const bool isInChain =
          expressions_.inChain[static_cast<std::size_t>(matched_.at(place.name.text))];
      if (isAny && !isInChain)
        tell(Code::MalformedPattern, place.tolerance->span, "'any' needs a chain",
             "'" + place.name.text + "' is not in a chain",
             "name the vertex in a `front` chain that leads to it, or give a tolerance");
    }
    definition().vertices.push_back(std::move(vertex));
    result_.vertexSpans.push_back(place.name.span);
  }
}

void ClauseCompiler::compileNear(const NearClause& clause) {
  for (const NearClause::Vertex& near : clause.vertices) {
    const Value at = expressions_.point(near.at);
    const auto reach = numberByLevel(near.reach, "a reach");
    const bool isBounded =
        reach && std::ranges::all_of(*reach, [](double r) { return r > 0 && r <= kLongestReach; });
    if (reach && !isBounded)
      tell(Code::MissingCounts, near.reach.span,
           "a reach is a distance above 0 and up to " + shownNumber(kLongestReach), "",
           "the unit is the target size; most reaches lie between 0.5 and 2.5");
    hasErrors_ = hasErrors_ || (!isGeneric_ && (at.isAny() || !isBounded));
    const auto index = static_cast<int>(definition().vertices.size());
    if (!defineLocal(near.name, algebra().vertex(index), LocalKind::Vertex)) continue;
    PatternVertex vertex;
    vertex.name = near.name.text;
    vertex.tolerance = std::nullopt;
    if (!at.isAny() && isBounded)
      vertex.near =
          NearPlace{makeTransform(builder_, algebra().toBase(at.at)), ByLevel<double>(*reach)};
    definition().vertices.push_back(std::move(vertex));
    result_.vertexSpans.push_back(near.name.span);
  }
}

/// Where vertices with a computed place are at the reference match, level by level.
void ClauseCompiler::placeNearVertices() {
  std::vector<PatternVertex>& vertices = definition().vertices;
  if (hasErrors_ || isGeneric_) return;
  for (std::size_t i = 2; i < vertices.size(); ++i) {
    if (!vertices[i].near) continue;
    std::vector<Point2> places;
    for (int level = 1; level <= lastLevel(); ++level) {
      const int used = std::max(level, definition().firstLevel);
      const RuleAtMatch match = RuleAtMatch::atReference(definition(), used);
      const auto place = vertices[i].near->place->transformPoint(match.binding());
      if (!place) {
        tell(Code::NoValue, result_.vertexSpans[i],
             "the place of '" + vertices[i].name + "' has no value at the reference match, level " +
                 std::to_string(used),
             "", "it is computed from a, b and the vertices above it");
        return;
      }
      places.push_back(*place);
    }
    vertices[i].reference = ReferenceByLevel(std::move(places));
  }
}

bool ClauseCompiler::isNewVertexOfRule(const std::string& name) const {
  const auto made = namesIn(rule_, {NameRole::NewVertex});
  return std::ranges::find(made, name, &Name::text) != made.end();
}

std::optional<int> ClauseCompiler::matchedVertex(const Name& name, const char* use) {
  const auto found = matched_.find(name.text);
  if (found != matched_.end()) return found->second;
  if (broken_.contains(name.text)) return std::nullopt;
  if (isNewVertexOfRule(name.text)) {
    tell(Code::MalformedPattern, name.span,
         "'" + name.text + "' is a new vertex; the front does not have it yet", "",
         std::string(use) + " names matched vertices only");
    return std::nullopt;
  }
  std::vector<std::string> known;
  for (const auto& [text, index] : matched_) known.push_back(text);
  const Help help = didYouMean(name.text, known);
  tell(Code::UnknownName, name.span, "the vertex '" + name.text + "' has no place", "",
       help.empty() ? "say where it is expected: `at " + name.text + " (x, y);`" : help);
  markBroken(name.text);
  return std::nullopt;
}

void ClauseCompiler::addEdge(const Name& fromName, const Name& toName) {
  const auto from = matchedVertex(fromName, "a chain"), to = matchedVertex(toName, "a chain");
  if (!from || !to) return;
  const Span span = cover(fromName.span, toName.span);
  if (*from == *to) return tell(Code::MalformedPattern, span, "an edge from a vertex to itself");
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
      return tell(Code::MalformedPattern, span, "the edge " + text + " is named twice", "",
                  "name each front edge once");
    }
    if (known.from == v && known.to == u)
      return tell(
          Code::MalformedPattern, span,
          "the edge " + text + " runs in the opposite direction of another edge of the pattern", "",
          "front edges have the unmeshed region on their left");
    if (known.from == u || known.to == v) {
      const Name& at = (known.from == u) != (mirror_ != nullptr) ? fromName : toName;
      return tell(Code::MalformedPattern, span, "the chains branch at '" + at.text + "'",
                  isBase ? "the base edge a -> b is always part of the pattern" : "",
                  "each vertex has one incoming and one outgoing front edge");
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
        tell(Code::DuplicateName, cover(slope.from.span, slope.to.span),
             "the slope of this edge is given twice", "", "give it once");
      edge.slope = form;
      const bool isIdle = !form || *form == ToleranceByLevel(ToleranceForm{0, 0, 0});
      if (isIdle && (isAny || !hasErrors_))
        expressions_.warnIdle(cover(slope.from.span, slope.tolerance.span),
                              "this slope accepts every edge",
                              "remove it, or give it a weight: a larger one is stricter");
      if (u == 0 && v == 1 && !mirror_)
        warn(Code::IdleClause, cover(slope.from.span, slope.tolerance.span),
             "a slope of the base edge tests its length only: the frame's x axis runs along it",
             "remove the clause if that is not meant");
      return;
    }
  tell(Code::MalformedPattern, cover(slope.from.span, slope.to.span),
       slope.from.text + " -> " + slope.to.text + " is not an edge of the pattern", "",
       "name it in a `front` chain; a slope is a tolerance on a front edge");
}

}  // namespace af2::dsl
