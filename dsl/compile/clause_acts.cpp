// Compiles what rules do beside adding elements: welds and paths.
#include "dsl/compile/clause_compiler.h"
#include "dsl/program/compiled_forms.h"
#include "engine/rule/free_zone.h"

namespace af2::dsl {

void ClauseCompiler::compileWeld(const WeldClause& clause, Span span) {
  const auto from = matchedVertex(clause.from, "weld"), into = matchedVertex(clause.into, "weld");
  const Value at = expressions_.point(clause.at);
  if (definition().weld)
    return tell(Code::DuplicateName, span, "this rule welds twice", "",
                "weld one pair of vertices in a rule");
  hasErrors_ = hasErrors_ || (!isGeneric_ && (at.isAny() || !from || !into));
  if (at.isAny() || !from || !into) return;
  use(UsedValue::Kind::NewVertex, at, clause.at.span);
  const NodePair place = algebra().toBase(at.at);
  definition().weld = RuleWeld{stored(*from), stored(*into), makeTransform(builder_, place)};
  definition().newVertices.push_back(definition().weld->place);
  definition().newVertexNames.push_back(clause.into.text + "'");  // no name of the language
  newPlaces_.push_back(place);
  result_.vertexSpans.push_back(clause.at.span);
  result_.actSpan = span;
}

void ClauseCompiler::compileFar(const FarClause& clause) {
  const auto index = static_cast<int>(definition().vertices.size());
  if (!defineLocal(clause.vertex, algebra().vertex(index), LocalKind::Vertex)) return;
  if (far_)
    return tell(Code::MalformedPattern, clause.vertex.span, "a rule has one far vertex", "",
                "a path has one end besides a");
  far_ = index;
  // Somewhere across the loop, for pictures.
  definition().vertices.push_back(PatternVertex{clause.vertex.text, {0.5, 2.5}, std::nullopt});
  result_.vertexSpans.push_back(clause.vertex.span);
}

void ClauseCompiler::compilePath(const PathClause& clause, Span span) {
  const auto from = matchedVertex(clause.from, "path"), to = matchedVertex(clause.to, "path");
  const Value segments = expressions_.number(clause.segments, "a number of edges");
  hasErrors_ = hasErrors_ || (!isGeneric_ && segments.isAny());
  if (!from || !to || segments.isAny()) return;
  if (definition().path)
    return tell(Code::DuplicateName, span, "this rule has two paths", "", "write one in each rule");
  if (*from != 0 || !far_ || *to != *far_)
    return tell(Code::MalformedPattern, span, "a path runs from a to the far vertex", "",
                "write `far c; path a -> c by dist(a, c);`");
  definition().path = RulePath{makeFunction(builder_, segments.number)};
  result_.actSpan = span;
}

/// A weld or a path has guards of its own; without a zone, that of a weld is what it closes.
void ClauseCompiler::addZoneOfAct() {
  if (!definition().weld && !definition().path) return;
  std::vector<ConvexPolygonZoneDef::Corner> corners;
  std::vector<int> vertices{0, 1, 2};
  if (definition().weld) {
    const auto [from, into, place] = *definition().weld;
    vertices = {0, 1, from > 1 ? from : into};
  }
  for (const int v : vertices)
    corners.push_back({std::make_shared<AffinePointTransform>(AffinePointTransform::vertex(v))});
  definition().zone = std::make_shared<ConvexPolygonZoneDef>(std::move(corners), std::vector{1.0});
}

}  // namespace af2::dsl
