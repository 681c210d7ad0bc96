// Compiles the zone clauses of a rule.
#include "dsl/compile/clause_compiler.h"
#include "dsl/compile/type_help.h"

#include <algorithm>

#include "dsl/program/compiled_forms.h"
#include "dsl/program/shape_program.h"

namespace af2::dsl {

void ClauseCompiler::readZone(const ZoneClause& clause, Span span) {
  ReadZone zone;
  zone.text = &clause;
  zone.isRight = clause.corners.size() != 2;
  if (!zone.isRight)
    tell(Code::ArgumentCount, span, "a zone needs at least three corners", "2 are given");
  if (isShapeClause(clause)) {
    zone.shape = oneShape(clause.corners[0]);
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
    zone.when = expressions_.truth(clause.when, "the argument of `when`");
    zone.isRight = zone.isRight && !zone.when.isAny();
  }
  hasErrors_ = hasErrors_ || !zone.isRight;
  zones_.push_back(std::move(zone));
  result_.zoneSpans.push_back(span);
}

Value ClauseCompiler::oneShape(const Expr& expr) {
  Value value = expressions_.evaluate(expr);
  if (value.isPoint()) {
    tell(Code::ArgumentCount, expr.span, "a zone needs at least three corners, or one shape",
         "1 corner is given",
         "list corners counter-clockwise, or use poly, hull, disc, left, sector, grow");
    return {};
  }
  if (value.isAny() || value.type == Type::Shape) return value;
  return expressions_.wrongType(expr, wantedShape(), value);
}

/// Converts a zone that is a list of corners to the engine's fast form.
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
    std::rotate(corners.begin(), corners.end() - 2, corners.end());  // a and b come first again
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

/// The vertices of the rule that are the corners of a polygon with straight sides; none if it has
/// other corners.
std::vector<std::int8_t> ClauseCompiler::cornerVerticesOf(const ShapeValue& shape) {
  const bool isPolygon = shape.kind == ShapeKind::Convex || shape.kind == ShapeKind::Poly;
  if (!isPolygon || std::ranges::find(shape.arcs, true) != shape.arcs.end()) return {};
  std::vector<NodePair> vertices(matched_.size());
  for (const auto& [name, vertex] : matched_)
    vertices[static_cast<std::size_t>(stored(vertex))] =
        algebra().toBase(algebra().vertex(vertex).at);
  vertices.insert(vertices.end(), newPlaces_.begin(), newPlaces_.end());
  std::vector<std::int8_t> corners;
  for (const NodePair& point : shape.points) {
    const auto found = std::ranges::find(vertices, point);
    if (found == vertices.end()) return {};
    corners.push_back(static_cast<std::int8_t>(found - vertices.begin()));
  }
  return corners;
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

/// Warns about a `when` that constants or an earlier `when` already decide.
void ClauseCompiler::tellIdleAlternatives() {
  std::vector<Node> before;
  for (const ReadZone& zone : zones_) {
    const Expr& when = zone.text->when;
    if (when.isMissing()) continue;
    const auto constant = builder_.constantValue(zone.when.number);
    if (constant)
      expressions_.warnIdle(when.span,
                            *constant != 0 ? "this condition always holds"
                                           : "this condition never holds, so the zone is not used",
                            "it does not depend on the match");
    else if (std::ranges::find(before, zone.when.number) != before.end())
      expressions_.warnIdle(when.span,
                            "this zone is never used: an earlier zone has the same condition",
                            "remove it, or give it another condition");
    before.push_back(zone.when.number);
  }
}

void ClauseCompiler::compileZones() {
  if (zones_.empty()) return;
  const auto hasWhen = [](const ReadZone& z) { return !z.text->when.isMissing(); };
  const bool hasConditions = std::any_of(zones_.begin(), zones_.end(), hasWhen);
  for (std::size_t i = 1; i < zones_.size(); ++i)
    if (hasConditions && !hasWhen(zones_[i - 1]))
      expressions_.tell(Code::IdleClause, result_.zoneSpans[i], "this zone is never used", "",
                        "the zone without `when` applies in all other cases; write it last");
  if (!std::all_of(zones_.begin(), zones_.end(), [](const ReadZone& z) { return z.isRight; }))
    return;
  tellIdleAlternatives();
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
  std::vector<std::int8_t> corners;
  if (united.size() == 1) corners = cornerVerticesOf(united[0]);
  if (!united.empty()) alternatives.push_back({nullptr, program(unionOf(std::move(united)))});
  definition().zone = std::make_shared<ShapeZoneDef>(std::move(alternatives), std::move(corners));
}

}  // namespace af2::dsl
