// Z2, Z4, Z5: the zone at the reference match.
#include <algorithm>
#include <string>

#include "dsl/checks/checks.h"
#include "dsl/shape_program.h"
#include "dsl/zone_corners.h"

namespace af2::dsl {
namespace {

double doubleArea(const std::vector<Point2>& corners) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return sum;
}

void tellClockwise(const CompiledRule& rule, Span zone, Findings& findings) {
  findings.add(rule, Severity::Error, "Z5", zone, "the zone runs clockwise at the reference match",
               "", "name its corners counter-clockwise, beginning with a, b");
}

void tellNotConvex(const CompiledRule& rule, Span zone, Findings& findings) {
  findings.add(rule, Severity::Warning, "Z2", zone, "the zone is not convex at the reference match",
               "the rule is refused there",
               "a list of corners must be convex; write poly(...) for other shapes");
}

bool turnsClockwise(const Shape& shape) {
  if (shape.kind() == ShapeKind::Convex || shape.kind() == ShapeKind::Poly)
    return doubleArea(shape.points()) < 0;
  for (const Shape& part : shape.parts())
    if (turnsClockwise(part)) return true;
  return false;
}

void checkShape(const CompiledRule& rule, const Shape& shape, Span zone, Findings& findings) {
  if (!isBounded(shape)) {
    findings.add(rule, Severity::Error, "Z4", zone, "this zone is unbounded", "",
                 "cut half planes with something bounded: `left(p, v) & disc(p, 2)`");
    return;
  }
  if (turnsClockwise(shape)) return tellClockwise(rule, zone, findings);
  const MadeZone made = makeZone(shape);
  if (made.zone) return;
  if (made.refusal == Refusal::Convexity) return tellNotConvex(rule, zone, findings);
  findings.add(rule, Severity::Warning, "Z2", zone,
               "the zone has no valid shape at the reference match", made.reason,
               "the rule is refused there");
}

/// One alternative for each zone clause; or one in all, which is the union of the clauses, and
/// whose parts are looked at one by one.
void checkAlternatives(const CompiledRule& rule, const ShapeZoneDef& zone,
                       const AF2Binding& binding, Findings& findings) {
  const auto& alternatives = zone.alternatives();
  for (std::size_t i = 0; i < alternatives.size(); ++i) {
    const auto shape = alternatives[i].shape->shapeAt(binding);
    if (!shape) continue;
    std::vector<Shape> parts{*shape};
    while (alternatives.size() == 1 && parts.size() < rule.zoneSpans.size() &&
           parts.front().kind() == ShapeKind::Union) {
      const Shape whole = parts.front();  // unions of clauses are grouped from the left
      parts.erase(parts.begin());
      parts.insert(parts.begin(), whole.parts().begin(), whole.parts().end());
    }
    for (std::size_t k = 0; k < parts.size(); ++k)
      checkShape(rule, parts[k], rule.zoneSpans[std::min(i + k, rule.zoneSpans.size() - 1)],
                 findings);
  }
}

}  // namespace

void checkZones(const CheckedRules& rules, Findings& findings) {
  for (const CompiledRule& rule : rules.rules) {
    if (rule.zoneSpans.empty()) continue;
    std::vector<Point2> points;
    for (const PatternVertex& v : rule.definition.vertices) points.push_back(v.reference);
    const AF2Surroundings uniform;
    const AF2Binding binding{points, rule.definition.firstLevel, &uniform};
    if (const auto* list = dynamic_cast<const ConvexPolygonZoneDef*>(rule.definition.zone.get())) {
      const auto corners = cornersAt(*list, binding);
      if (corners.empty()) continue;
      if (doubleArea(corners) < 0)
        tellClockwise(rule, rule.zoneSpans.front(), findings);
      else if (!ConvexPolygonZone::isConvex(corners))
        tellNotConvex(rule, rule.zoneSpans.front(), findings);
    } else if (const auto* free = dynamic_cast<const ShapeZoneDef*>(rule.definition.zone.get())) {
      checkAlternatives(rule, *free, binding, findings);
    }
  }
}

}  // namespace af2::dsl
