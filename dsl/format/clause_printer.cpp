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

std::string reasonText(const ExpectedReason& reason) {
  return reason.words +
         (reason.vertices.empty() ? "" : " " + join(reason.vertices, nameOf, " -> "));
}

std::string ruleOutcome(const ExpectRule& r) {
  std::string text = "rule " + quoted(r.title.text);
  if (!r.bindings.empty())
    text += " with " +
            join(r.bindings, [](const auto& b) { return b.first.text + " = " + b.second.text; });
  for (std::size_t i = 0; i < r.reasons.size(); ++i)
    text += (i == 0 ? " because " : " or ") + reasonText(r.reasons[i]);
  return text;
}

std::string outcomeText(const ExpectedOutcome& outcome) {
  return match(
      outcome, [](std::monostate) { return std::string(); },
      [](const ExpectRule& o) { return ruleOutcome(o); },
      [](const ExpectNew& o) {
        return "new " + std::to_string(o.index) + " at " + pairText(o.x, o.y);
      },
      [](const ExpectFront& o) {
        return std::string("front ") + (o.only ? "only " : "") +
               join(o.chains, [](const auto& c) { return join(c, expectedVertexText, " -> "); });
      },
      [](const ExpectElements& o) { return "elements " + std::to_string(o.count); },
      [](const ExpectWeld& o) { return "weld " + o.from.text + " into " + o.into.text; },
      [](const ExpectStuck&) { return std::string("stuck"); },
      [](const ExpectScore& o) { return "score " + o.comparison + " " + printExpression(o.value); },
      [](const ExpectCondition& o) { return printExpression(o.condition); });
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
  return match(
      clause.content, [](std::monostate) { return Line(); },
      [](const FrontClause& c) {
        return Line{"front", join(c.chains, chainText) + ";"};
      },
      [](const AtClause& c) {
        return Line{"at", join(c.places, placeText) + ";"};
      },
      [](const NearClause& c) {
        const auto text = [](const NearClause::Vertex& v) {
          return v.name.text + " of " + printExpression(v.at) + " within " +
                 printExpression(v.reach);
        };
        return Line{"near", join(c.vertices, text) + ";"};
      },
      [](const SlopeClause& c) {
        return Line{"slope",
                    c.from.text + " -> " + c.to.text + " " + toleranceText(c.tolerance) + ";"};
      },
      [](const LetClause& c) {
        return Line{"let", join(c.values, definitionText) + ";"};
      },
      [](const NewClause& c) {
        return Line{"new", join(c.vertices, definitionText) + ";"};
      },
      [](const ZoneClause& c) {
        const std::string when = c.when.isMissing() ? "" : " when " + printExpression(c.when);
        return Line{"zone", join(c.corners, printExpression) + when + ";"};
      },
      [](const ElementClause& c) {
        const auto corners = [](const auto& element) { return join(element, nameOf, " "); };
        return Line{c.kind.text, join(c.elements, corners) + ";"};
      },
      [](const WeldClause& c) {
        return Line{"weld",
                    c.from.text + " into " + c.into.text + " at " + printExpression(c.at) + ";"};
      },
      [](const FarClause& c) {
        return Line{"far", c.vertex.text + ";"};
      },
      [](const PathClause& c) {
        return Line{"path",
                    c.from.text + " -> " + c.to.text + " by " + printExpression(c.segments) + ";"};
      },
      [](const RequireClause& c) {
        return Line{"require", join(c.conditions, printExpression) + ";"};
      },
      [](const CostClause& c) {
        return Line{"cost", printExpression(c.value) + ";"};
      },
      [](const PriorityClause& c) {
        return Line{"priority", printExpression(c.value) + ";"};
      },
      [](const MetaClause& c) {
        return Line{"meta", metaText(c)};
      },
      [](const MirrorClause& c) {
        return Line{"mirror", mirrorText(c)};
      });
}

Line lineOf(const Setting& setting) {
  return match(
      setting.content, [](std::monostate) { return Line(); },
      [](const ElementsSetting& c) {
        return Line{"elements", join(c.kinds, nameOf) + ";"};
      },
      [](const MatchSetting& c) {
        return Line{"match", printExpression(c.value) + ";"};
      },
      [](const FadeSetting& c) {
        return Line{"fade", printExpression(c.value) + ";"};
      },
      [](const ScoreSetting& c) {
        return Line{"score", c.fold.text + " of " + printExpression(c.metric) + ";"};
      },
      [](const AcceptSetting& c) {
        return Line{"accept", join(c.conditions, printExpression) + ";"};
      },
      [](const ClearSetting& c) {
        return Line{"clear", printExpression(c.value) + ";"};
      },
      [](const OrderSetting& c) {
        return Line{"front", "by " + join(c.keys, printExpression) + ";"};
      },
      [](const RowsSetting& c) {
        const std::string arguments =
            join(c.arguments, [](const MetaEntry& e) { return e.key.text + ": " + e.value.text; });
        return Line{"front", "rows" + (arguments.empty() ? "" : "(" + arguments + ")") + ";"};
      },
      [](const RowEndSetting& c) {
        return Line{"at", "row smooth " + printExpression(c.rounds) + ";"};
      },
      [](const EndSetting& c) {
        return Line{"at", "end clean " + printExpression(c.depth) + ";"};
      },
      [](const CountsSetting& c) {
        return Line{"counts", join(c.bounds, printExpression) + ";"};
      },
      [](const ColumnsSetting& c) {
        return Line{"columns", printExpression(c.low) + ".." + printExpression(c.high) +
                                   " from layer " + printExpression(c.layer) + ";"};
      },
      [](const ClassesSetting& c) {
        return Line{"classes", printExpression(c.first) + ".." + printExpression(c.last) + ";"};
      },
      [](const ScaleSetting& c) {
        return Line{"scale", c.unit.text + ";"};
      },
      [](const ParitySetting& c) {
        return Line{"parity", c.parity.text + ";"};
      },
      [](const FinishSetting& c) {
        return Line{"finish", c.finish.text + ";"};
      },
      [](const MetaClause& c) {
        return Line{"meta", metaText(c)};
      });
}

Line lineOf(const TestClause& clause) {
  return match(
      clause.content, [](std::monostate) { return Line(); },
      [](const TestFront& c) {
        const auto text = [](const auto& chain) { return join(chain, vertexText, " -> "); };
        return Line{"front", join(c.chains, text) + ";"};
      },
      [](const TestPoints& c) {
        return Line{"point", join(c.points, vertexText) + ";"};
      },
      [](const TestColours& c) {
        const auto text = [](const VertexColour& v) {
          return v.vertex.text + " " + std::to_string(v.colour);
        };
        return Line{"colours", join(c.colours, text) + ";"};
      },
      [](const TestBase& c) {
        return Line{"base", c.from.text + " -> " + c.to.text + ";"};
      },
      [](const TestLevel& c) {
        return Line{"class", printExpression(c.value) + ";"};
      },
      [](const TestSize& c) {
        return Line{"size", printExpression(c.value) + ";"};
      },
      [](const Expectation& c) {
        return Line{"expect", std::string(c.negated ? "not " : "") + outcomeText(c.outcome) + ";"};
      });
}

std::string ruleHeader(const Rule& rule) {
  return "rule " + quoted(rule.title.text) + (rule.family ? " " + familyText(*rule.family) : "") +
         " quality " + levelsText(rule.levels);
}

}  // namespace af2::dsl
