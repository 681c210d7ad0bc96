#include "dsl/netgen/rls_rule_check.h"

namespace af2::dsl {

void checkRlsRule(const RlsRule& rule, RlsReader& reader) {
  const auto old = static_cast<int>(rule.mapPoints.size());
  const int all = old + static_cast<int>(rule.newPoints.size());
  const auto check = [&](int point, Span span, int most, const char* kind) {
    if (point >= 1 && point <= most) return;
    reader.tell(Code::NetgenContradiction, span, "there is no point " + std::to_string(point),
                "this rule has " + std::to_string(most) + " " + kind);
  };
  if (rule.mapLines.empty())
    reader.tell(Code::NetgenContradiction, rule.span, "this rule has no maplines",
                "the first of them is the base edge: maplines (1, 2) del;");
  for (const RlsLine& line : rule.mapLines)
    for (int point : {line.from, line.to}) check(point, line.span, old, "mappoints");
  for (const auto* tuples : {&rule.elements, &rule.newLines})
    for (const RlsTuple& tuple : *tuples)
      for (int point : tuple.points) check(point, tuple.span, all, "points, new ones included");
  for (const RlsTuple& tuple : rule.orientations)
    for (int point : tuple.points) check(point, tuple.span, old, "mappoints");
  if (rule.elements.empty())
    reader.tell(Code::NetgenContradiction, rule.span, "this rule makes no elements",
                "give it 'elements'");
  if (rule.freeArea.size() < 3)
    reader.tell(Code::NetgenContradiction, rule.span, "a free area has three corners or more",
                "this one has " + std::to_string(rule.freeArea.size()));
  if (rule.elements.size() > kMaxRlsElements)
    reader.tell(Code::NetgenContradiction, rule.span, "a rule makes at most 8 elements",
                "this one makes " + std::to_string(rule.elements.size()));
  if (static_cast<std::size_t>(all) > kMaxRlsPoints)
    reader.tell(Code::NetgenContradiction, rule.span,
                "a rule has at most 12 points, new ones included", "split it");
}

}  // namespace af2::dsl
