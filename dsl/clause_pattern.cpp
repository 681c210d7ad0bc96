// What a rule looks for: levels, places, tolerances, chains.
#include "dsl/clause_compiler.h"

#include <algorithm>
#include <cmath>

#include "dsl/builtins.h"
#include "dsl/words.h"

namespace af2::dsl {

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
  if (expr.kind == ExprKind::Tuple && !isForm) {
    for (const Expr& part : expr.parts) expressions_.constantNumber(part, "a coefficient");
    tell("Y6", expr.span, "a form has three coefficients, (xx, xy, yy)",
         std::to_string(expr.parts.size()) + " are given",
         "write `~ w` for the same weight in all directions, or `~ (xx, xy, yy)`");
    return std::nullopt;
  }
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
      const bool isIdle = !form || (form->xx == 0 && form->xy == 0 && form->yy == 0);
      if (isIdle && (isAny || !hasErrors_))
        expressions_.warnIdle(cover(slope.from.span, slope.tolerance.span),
                              "this slope lets every edge through",
                              "remove it, or give it a weight: a larger one is stricter");
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

}  // namespace af2::dsl
