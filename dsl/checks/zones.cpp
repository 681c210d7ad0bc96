// Z2, Z4, Z5: the zone at the reference match.
#include <string>

#include "dsl/checks/checks.h"
#include "dsl/shape_program.h"

namespace af2::dsl {
namespace {

double doubleArea(const std::vector<Point2>& corners) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return sum;
}

std::vector<Point2> cornersAt(const ConvexPolygonZoneDef& zone, const AF2Binding& binding) {
  std::vector<Point2> corners;
  const double t = zone.fade(binding.level);
  for (const auto& corner : zone.corners()) {
    const auto p = corner.preferred->transformPoint(binding);
    const auto l = corner.limiting ? corner.limiting->transformPoint(binding) : p;
    if (!p || !l) return {};
    corners.push_back(corner.limiting ? t * *p + (1 - t) * *l : *p);
  }
  return corners;
}

void tellClockwise(const CompiledRule& rule, Findings& findings) {
  findings.add(rule, Severity::Error, "Z5", rule.zoneSpans.front(),
               "the zone runs clockwise at the reference match", "",
               "name its corners counter-clockwise, beginning with a, b");
}

void tellNotConvex(const CompiledRule& rule, Findings& findings) {
  findings.add(rule, Severity::Warning, "Z2", rule.zoneSpans.front(),
               "the zone is not convex at the reference match", "the rule is refused there",
               "a list of corners must be convex; write poly(...) for other shapes");
}

bool turnsClockwise(const Shape& shape) {
  if (shape.kind() == ShapeKind::Convex || shape.kind() == ShapeKind::Poly)
    return doubleArea(shape.points()) < 0;
  for (const Shape& part : shape.parts())
    if (turnsClockwise(part)) return true;
  return false;
}

void checkShape(const CompiledRule& rule, const Shape& shape, Findings& findings) {
  if (!isBounded(shape)) {
    findings.add(rule, Severity::Error, "Z4", rule.zoneSpans.front(), "this zone is unbounded", "",
                 "cut half planes with something bounded: `left(p, v) & disc(p, 2)`");
    return;
  }
  if (turnsClockwise(shape)) return tellClockwise(rule, findings);
  const MadeZone made = makeZone(shape);
  if (made.zone) return;
  if (made.refusal == Refusal::Convexity) return tellNotConvex(rule, findings);
  findings.add(rule, Severity::Warning, "Z2", rule.zoneSpans.front(),
               "the zone has no valid shape at the reference match", made.reason,
               "the rule is refused there");
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
        tellClockwise(rule, findings);
      else if (!ConvexPolygonZone::isConvex(corners))
        tellNotConvex(rule, findings);
    } else if (const auto* free = dynamic_cast<const ShapeZoneDef*>(rule.definition.zone.get())) {
      for (const auto& alternative : free->alternatives())
        if (const auto shape = alternative.shape->shapeAt(binding))
          checkShape(rule, *shape, findings);
    }
  }
}

}  // namespace af2::dsl
