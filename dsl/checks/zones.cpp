// Z2, Z4, Z5: the zone at the reference match.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "dsl/checks/checks.h"
#include "dsl/program/shape_program.h"
#include "engine/base/turn.h"
#include "engine/rule/rule_at_match.h"

namespace af2::dsl {
namespace {

double doubleArea(const std::vector<Point2>& corners) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return sum;
}

bool turnsClockwise(const Shape& shape) {
  if (shape.kind() == ShapeKind::Convex || shape.kind() == ShapeKind::Poly)
    return doubleArea(shape.points()) < 0;
  for (const Shape& part : shape.parts())
    if (turnsClockwise(part)) return true;
  return false;
}

/// The zone of one rule at one level.
class ZoneCheck {
 public:
  ZoneCheck(const CompiledRule& rule, int level, Findings& findings)
      : rule_(rule), level_(level), findings_(findings) {}

  /// Whether something was reported.
  bool run() {
    const RuleAtMatch match = RuleAtMatch::atReference(rule_.definition, level_);
    const AF2FreeZoneDef* zone = rule_.definition.zone.get();
    if (const auto* list = dynamic_cast<const ConvexPolygonZoneDef*>(zone))
      checkCorners(list->cornersAt(match.binding()).value_or(std::vector<Point2>()));
    else if (const auto* free = dynamic_cast<const ShapeZoneDef*>(zone))
      checkAlternatives(*free, match.binding());
    return hasTold_;
  }

 private:
  void tell(Code code, Span zone, const std::string& message, std::string label, std::string help) {
    hasTold_ = true;
    findings_.add(rule_, code, zone, message, std::move(label), std::move(help));
  }

  /// The corners of a list in counter-clockwise order, if all of them are corners of their convex
  /// hull; otherwise nothing.
  std::string orderedCorners(Span zone) const {
    const ZoneClause* list = listAt(zone);
    if (!list || corners_.size() != list->corners.size() || rule_.isMirror) return {};
    std::vector<std::size_t> order(corners_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    Point2 middle{};
    for (const Point2 p : corners_) middle = middle + (1.0 / double(corners_.size())) * p;
    const auto angle = [&](std::size_t i) {
      const Point2 d = corners_[i] - middle, from = corners_[0] - middle;
      return i == 0 ? 0 : turnBetween(from, d);
    };
    std::ranges::sort(order, {}, angle);
    std::vector<Point2> sorted;
    std::string text;
    for (const std::size_t i : order) {
      sorted.push_back(corners_[i]);
      const Span span = list->corners[i].span;
      text += (text.empty() ? "" : ", ") +
              std::string(rule_.home->source.text().substr(span.begin, span.end - span.begin));
    }
    if (!ConvexPolygonZone::isConvex(sorted)) return {};
    return "counter-clockwise its corners are `zone " + text + ";`";
  }

  const ZoneClause* listAt(Span zone) const {
    for (const Clause& clause : rule_.text->clauses)
      if (clause.span == zone)
        if (const auto* list = std::get_if<ZoneClause>(&clause.content)) return list;
    return nullptr;
  }

  void tellClockwise(Span zone) {
    const std::string below = belowBase(rule_, level_), order = orderedCorners(zone);
    tell(Code::ClockwiseZone, zone, "the zone runs clockwise at " + referenceName(rule_, level_),
         "",
         !below.empty()   ? below
         : !order.empty() ? order
                          : "name its corners counter-clockwise, beginning with a, b");
  }

  void tellNotConvex(Span zone) {
    const std::string order = orderedCorners(zone);
    tell(Code::InvalidZone, zone, "the zone is not convex at " + referenceName(rule_, level_),
         "the rule is refused there",
         order.empty() ? "a list of corners must be convex; write poly(...) for other shapes"
                       : order);
  }

  void checkCorners(std::vector<Point2> corners) {
    corners_ = std::move(corners);
    if (corners_.empty()) return;
    if (doubleArea(corners_) < 0)
      tellClockwise(rule_.zoneSpans.front());
    else if (!ConvexPolygonZone::isConvex(corners_))
      tellNotConvex(rule_.zoneSpans.front());
  }

  void checkShape(const Shape& shape, Span zone) {
    if (!isBounded(shape))
      return tell(Code::UnboundedZone, zone, "this zone is unbounded", "",
                  "cut half planes with something bounded: `left(p, v) & disc(p, 2)`");
    if (turnsClockwise(shape)) return tellClockwise(zone);
    const MadeZone made = makeZone(shape);
    if (made.zone) return;
    if (made.refusal == Refusal::Convexity) return tellNotConvex(zone);
    tell(Code::InvalidZone, zone, "the zone has no valid shape at " + referenceName(rule_, level_),
         made.reason, "the rule is refused there");
  }

  /// There is one alternative for each zone clause, or a single one: the union of the clauses,
  /// whose parts are checked one by one.
  void checkAlternatives(const ShapeZoneDef& zone, const AF2Binding& binding) {
    const auto& alternatives = zone.alternatives();
    const std::vector<Span>& spans = rule_.zoneSpans;
    for (std::size_t i = 0; i < alternatives.size(); ++i) {
      const auto shape = alternatives[i].shape->shapeAt(binding);
      if (!shape) continue;
      std::vector<Shape> parts{*shape};
      while (alternatives.size() == 1 && parts.size() < spans.size() &&
             parts.front().kind() == ShapeKind::Union) {
        const Shape whole = parts.front();  // unions of clauses are left-associative
        parts.erase(parts.begin());
        parts.insert(parts.begin(), whole.parts().begin(), whole.parts().end());
      }
      for (std::size_t k = 0; k < parts.size(); ++k)
        checkShape(parts[k], spans[std::min(i + k, spans.size() - 1)]);
    }
  }

  const CompiledRule& rule_;
  int level_;
  Findings& findings_;
  std::vector<Point2> corners_;  // of a list
  bool hasTold_ = false;
};

}  // namespace

void checkZones(const CheckedRules& rules, Findings& findings) {
  for (const CompiledRule& rule : rules.rules) {
    if (rule.zoneSpans.empty()) continue;
    for (const int level : referenceLevels(rule.definition))
      if (ZoneCheck(rule, level, findings).run()) break;
  }
}

}  // namespace af2::dsl
