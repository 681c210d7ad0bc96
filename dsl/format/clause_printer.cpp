#include "dsl/format/clause_printer.h"

#include "dsl/format/printer.h"

namespace af2::dsl {
namespace {

std::string chainText(const Chain& chain) { return join(chain, nameOf, " -> "); }

std::string toleranceText(const Tolerance& t) {
  return "~ " + (t.any ? "any" : printExpression(t.form));
}

std::string pairText(const Expr& x, const Expr& y) {
  return "(" + printExpression(x) + ", " + printExpression(y) + ")";
}

std::string placeText(const Place& p) {
  return p.name.text + " " + pairText(p.x, p.y) +
         (p.tolerance ? " " + toleranceText(*p.tolerance) : "");
}

std::string definitionText(const Definition& d) {
  return d.name.text + " = " + printExpression(d.value);
}

std::string levelsText(const LevelRange& l) {
  return printExpression(l.first) + (l.last.isMissing() ? "" : ".." + printExpression(l.last));
}

std::string metaText(const MetaClause& meta) {
  std::string text = "{";
  for (const MetaEntry& e : meta.entries)
    text += " " + e.key.text + " " + quoted(e.value.text) + ";";
  return text + " }";
}

std::string overrideText(const MirrorOverride& part) {
  if (part.levels) return "quality " + levelsText(*part.levels) + ";";
  if (part.cost) return "cost " + printExpression(part.cost->value) + ";";
  return "at " +
         join(part.tolerances,
              [](const auto& v) { return v.name.text + " " + toleranceText(v.tolerance); }) +
         ";";
}

std::string mirrorText(const MirrorClause& mirror) {
  std::string text = quoted(mirror.title.text);
  if (!mirror.hasBody) return text + ";";
  text += " {";
  for (const MirrorOverride& part : mirror.overrides) text += " " + overrideText(part);
  return text + " }";
}

std::string vertexText(const TestVertex& v) {
  return v.name.text + (v.isPlaced ? " " + pairText(v.x, v.y) : "");
}

std::string expectedVertexText(const ExpectedVertex& v) {
  return v.newIndex > 0 ? "new " + std::to_string(v.newIndex) : v.name.text;
}

std::string ruleOutcome(const ExpectRule& r) {
  std::string text = "rule " + quoted(r.title.text);
  if (!r.bindings.empty())
    text += " with " +
            join(r.bindings, [](const auto& b) { return b.first.text + " = " + b.second.text; });
  if (r.reason.empty()) return text;
  return text + " because " + r.reason +
         (r.reasonVertices.empty() ? "" : " " + join(r.reasonVertices, nameOf, " -> "));
}

std::string outcomeText(const ExpectedOutcome& outcome) {
  return std::visit(
      [](const auto& o) -> std::string {
        using O = std::decay_t<decltype(o)>;
        if constexpr (std::is_same_v<O, ExpectRule>)
          return ruleOutcome(o);
        else if constexpr (std::is_same_v<O, ExpectNew>)
          return "new " + std::to_string(o.index) + " at " + pairText(o.x, o.y);
        else if constexpr (std::is_same_v<O, ExpectFront>)
          return std::string("front ") + (o.only ? "only " : "") +
                 join(o.chains, [](const auto& c) { return join(c, expectedVertexText, " -> "); });
        else if constexpr (std::is_same_v<O, ExpectElements>)
          return "elements " + std::to_string(o.count);
        else if constexpr (std::is_same_v<O, ExpectStuck>)
          return "stuck";
        else if constexpr (std::is_same_v<O, ExpectScore>)
          return "score " + o.comparison + " " + printExpression(o.value);
        else if constexpr (std::is_same_v<O, ExpectCondition>)
          return printExpression(o.condition);
        else
          return "";
      },
      outcome);
}

std::string familyText(const Family& family) {
  return "for (" + join(family.names, nameOf) + ") in " + join(family.tuples, printExpression);
}

}  // namespace

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

Line lineOf(const Clause& clause) {
  return std::visit(
      [](const auto& c) -> Line {
        using C = std::decay_t<decltype(c)>;
        if constexpr (std::is_same_v<C, FrontClause>)
          return {"front", join(c.chains, chainText) + ";"};
        else if constexpr (std::is_same_v<C, AtClause>)
          return {"at", join(c.places, placeText) + ";"};
        else if constexpr (std::is_same_v<C, SlopeClause>)
          return {"slope",
                  c.from.text + " -> " + c.to.text + " " + toleranceText(c.tolerance) + ";"};
        else if constexpr (std::is_same_v<C, LetClause>)
          return {"let", join(c.values, definitionText) + ";"};
        else if constexpr (std::is_same_v<C, NewClause>)
          return {"new", join(c.vertices, definitionText) + ";"};
        else if constexpr (std::is_same_v<C, ZoneClause>)
          return {"zone", join(c.corners, printExpression) +
                              (c.when.isMissing() ? "" : " when " + printExpression(c.when)) + ";"};
        else if constexpr (std::is_same_v<C, ElementClause>)
          return {c.kind.text,
                  join(c.elements, [](const auto& e) { return join(e, nameOf, " "); }) + ";"};
        else if constexpr (std::is_same_v<C, RequireClause>)
          return {"require", join(c.conditions, printExpression) + ";"};
        else if constexpr (std::is_same_v<C, CostClause>)
          return {"cost", printExpression(c.value) + ";"};
        else if constexpr (std::is_same_v<C, PriorityClause>)
          return {"priority", printExpression(c.value) + ";"};
        else if constexpr (std::is_same_v<C, MetaClause>)
          return {"meta", metaText(c)};
        else if constexpr (std::is_same_v<C, MirrorClause>)
          return {"mirror", mirrorText(c)};
        else
          return {};
      },
      clause.content);
}

Line lineOf(const Setting& setting) {
  return std::visit(
      [](const auto& c) -> Line {
        using C = std::decay_t<decltype(c)>;
        if constexpr (std::is_same_v<C, ElementsSetting>)
          return {"elements", join(c.kinds, nameOf) + ";"};
        else if constexpr (std::is_same_v<C, MatchSetting>)
          return {"match", printExpression(c.value) + ";"};
        else if constexpr (std::is_same_v<C, FadeSetting>)
          return {"fade", printExpression(c.value) + ";"};
        else if constexpr (std::is_same_v<C, ScoreSetting>)
          return {"score", c.fold.text + " of " + printExpression(c.metric) + ";"};
        else if constexpr (std::is_same_v<C, AcceptSetting>)
          return {"accept", printExpression(c.condition) + ";"};
        else if constexpr (std::is_same_v<C, OrderSetting>)
          return {"front", "by " + join(c.keys, printExpression) + ";"};
        else if constexpr (std::is_same_v<C, RowsSetting>) {
          const std::string arguments = join(
              c.arguments, [](const MetaEntry& e) { return e.key.text + ": " + e.value.text; });
          return {"front", "rows" + (arguments.empty() ? "" : "(" + arguments + ")") + ";"};
        } else if constexpr (std::is_same_v<C, ClassesSetting>)
          return {"classes", printExpression(c.first) + ".." + printExpression(c.last) + ";"};
        else if constexpr (std::is_same_v<C, ScaleSetting>)
          return {"scale", c.unit.text + ";"};
        else if constexpr (std::is_same_v<C, ParitySetting>)
          return {"parity", c.parity.text + ";"};
        else if constexpr (std::is_same_v<C, MetaClause>)
          return {"meta", metaText(c)};
        else
          return {};
      },
      setting.content);
}

Line lineOf(const TestClause& clause) {
  return std::visit(
      [](const auto& c) -> Line {
        using C = std::decay_t<decltype(c)>;
        if constexpr (std::is_same_v<C, TestFront>)
          return {"front", join(c.chains, [](const auto& chain) {
                             return join(chain, vertexText, " -> ");
                           }) + ";"};
        else if constexpr (std::is_same_v<C, TestPoints>)
          return {"point", join(c.points, vertexText) + ";"};
        else if constexpr (std::is_same_v<C, TestBase>)
          return {"base", c.from.text + " -> " + c.to.text + ";"};
        else if constexpr (std::is_same_v<C, TestLevel>)
          return {"class", printExpression(c.value) + ";"};
        else if constexpr (std::is_same_v<C, TestSize>)
          return {"size", printExpression(c.value) + ";"};
        else if constexpr (std::is_same_v<C, Expectation>)
          return {"expect", std::string(c.negated ? "not " : "") + outcomeText(c.outcome) + ";"};
        else
          return {};
      },
      clause.content);
}

std::string ruleHeader(const Rule& rule) {
  return "rule " + quoted(rule.title.text) + (rule.family ? " " + familyText(*rule.family) : "") +
         " quality " + levelsText(rule.levels);
}

}  // namespace af2::dsl
