// Finds levels at which an expression of a rule has no value for any match.
#include <algorithm>

#include "dsl/compile/clause_compiler.h"

namespace af2::dsl {
namespace {

void collect(const ShapeValue& shape, std::vector<Node>& nodes) {
  for (const NodePair p : shape.points) nodes.insert(nodes.end(), {p.x, p.y});
  nodes.insert(nodes.end(), shape.numbers.begin(), shape.numbers.end());
  for (const auto& part : shape.parts) collect(*part, nodes);
}

void collect(const Value& value, std::vector<Node>& nodes) {
  if (value.type == Type::Shape)
    collect(*value.shape, nodes);
  else if (value.type == Type::Geometric)
    nodes.insert(nodes.end(), {value.at.x, value.at.y});
  else if (!value.isAny())
    nodes.push_back(value.number);
}

const char* nameOf(ClauseCompiler::UsedValue::Kind kind) {
  using Kind = ClauseCompiler::UsedValue::Kind;
  switch (kind) {
    case Kind::Requirement:
      return "the argument of `require`";
    case Kind::NewVertex:
      return "the place of a new vertex";
    case Kind::Cost:
      return "the cost";
    case Kind::When:
      return "the argument of `when`";
    case Kind::Zone:
      break;
  }
  return "this part of the zone";
}

}  // namespace

void ClauseCompiler::use(UsedValue::Kind kind, const Value& value, Span span) {
  const std::size_t first = usedNodes_.size();
  collect(value, usedNodes_);
  used_.push_back({kind, span, first, usedNodes_.size()});
}

/// In the order of evaluation: each zone after its condition.
void ClauseCompiler::useZones() {
  for (const ReadZone& zone : zones_) {
    if (!zone.text->when.isMissing()) use(UsedValue::Kind::When, zone.when, zone.text->when.span);
    if (isShapeClause(*zone.text))
      use(UsedValue::Kind::Zone, zone.shape, zone.text->corners[0].span);
    for (std::size_t i = 0; i < zone.corners.size(); ++i) {
      use(UsedValue::Kind::Zone, zone.corners[i].preferred, zone.text->corners[i].span);
      if (zone.corners[i].limiting)
        use(UsedValue::Kind::Zone, *zone.corners[i].limiting, zone.text->corners[i].span);
    }
  }
}

/// Each fault is reported once, at the lowest level. An expression that is not evaluated because an
/// earlier condition fails may have no value.
void ClauseCompiler::tellMissingValues() {
  if (hasErrors_ || isGeneric_) return;
  useZones();
  std::ranges::stable_sort(used_, [](const UsedValue& p, const UsedValue& q) {
    return p.kind == UsedValue::Kind::Requirement && q.kind != UsedValue::Kind::Requirement;
  });
  const Program program = builder_.program(usedNodes_);
  if (!asksForLevel(program)) return;
  for (int level = definition().firstLevel; level <= lastLevel(); ++level)
    tellMissingAt(level, KnownResults(program, level));
}

void ClauseCompiler::tellMissingAt(int level, KnownResults known) {
  bool isZoneAsked = true;
  for (UsedValue& used : used_) {
    if (used.kind == UsedValue::Kind::Zone && !isZoneAsked) continue;
    if (used.kind == UsedValue::Kind::When) isZoneAsked = !known[used.first].isFalse();
    for (std::size_t i = used.first; i < used.last; ++i) {
      if (!known[i].isNone()) continue;
      if (!used.isTold)
        expressions_.tell(
            Code::NoValue, used.span,
            nameOf(used.kind) + std::string(" has no value at level ") + std::to_string(level),
            "the rule is refused there",
            "a division by zero, a root of a negative number or the like", {}, Severity::Warning);
      used.isTold = true;
      known.forget(i);
    }
    if (used.kind == UsedValue::Kind::Requirement && known[used.first].isFalse()) return;
  }
}

}  // namespace af2::dsl
