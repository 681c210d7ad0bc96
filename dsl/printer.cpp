#include "dsl/printer.h"

#include <algorithm>

namespace af2::dsl {
namespace {

/// A clause as its first word and the rest.
struct Line {
  std::string word, rest;
};

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

template <class List, class Print>
std::string join(const List& list, Print print, const char* separator = ", ") {
  std::string text;
  bool isFirst = true;
  for (const auto& part : list) {
    if (!isFirst) text += separator;
    isFirst = false;
    text += print(part);
  }
  return text;
}

std::string nameOf(const Name& name) { return name.text; }

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

std::string familyText(const Family& family) {
  return "for (" + join(family.names, nameOf) + ") in " + join(family.tuples, printExpression);
}

std::string ruleHeader(const Rule& rule) {
  return "rule " + quoted(rule.title.text) + (rule.family ? " " + familyText(*rule.family) : "") +
         " quality " + levelsText(rule.levels);
}

/// Writes items with the comments that stand before, between and behind them.
class Printer {
 public:
  Printer(const SourceText& source, const ParsedFile& parsed) : source_(source), parsed_(parsed) {}

  std::string print() {
    const std::uint32_t firstItem =
        parsed_.file.items.empty() ? end() : parsed_.file.items.front().span.begin;
    commentsBefore(versionBegin(), "");
    out_ += "af2 1;";
    trailingComment(versionBegin(), firstItem);
    out_ += "\n";
    previousEnd_ = versionBegin();
    for (const Item& item : parsed_.file.items) printItem(item);
    commentsBefore(end(), "");
    return std::move(out_);
  }

 private:
  std::uint32_t end() const { return static_cast<std::uint32_t>(source_.text().size()); }

  /// Where `af2` stands: behind the comments that may open a file.
  std::uint32_t versionBegin() const {
    std::uint32_t at = source_.text().starts_with("\xEF\xBB\xBF") ? 3 : 0;
    std::size_t c = 0;
    const auto text = source_.text();
    while (at < text.size()) {
      if (c < parsed_.comments.size() && parsed_.comments[c].span.begin == at)
        at = parsed_.comments[c++].span.end;
      else if (text[at] == ' ' || text[at] == '\n' || text[at] == '\t' || text[at] == '\r')
        ++at;
      else
        break;
    }
    return at;
  }

  int line(std::uint32_t offset) const { return source_.lineOf(offset); }

  void blankLineIfThereWasOne(std::uint32_t begin) {
    if (out_.empty() || out_.ends_with("\n\n") || out_.ends_with("{\n")) return;
    if (line(begin) - line(previousEnd_) > 1) out_ += "\n";
  }

  /// All comments that begin before `offset`, each on a line of its own.
  void commentsBefore(std::uint32_t offset, const std::string& indent) {
    while (next_ < parsed_.comments.size() && parsed_.comments[next_].span.begin < offset) {
      const Comment& comment = parsed_.comments[next_++];
      blankLineIfThereWasOne(comment.span.begin);
      out_ += indent + comment.text + "\n";
      previousEnd_ = comment.span.end;
    }
  }

  /// A comment on the line on which something ended, if it begins before `limit`.
  void trailingComment(std::uint32_t endedAt, std::uint32_t limit) {
    if (next_ >= parsed_.comments.size()) return;
    const Comment& comment = parsed_.comments[next_];
    if (comment.ownLine || comment.span.begin >= limit || line(comment.span.begin) != line(endedAt))
      return;
    out_ += "  " + comment.text;
    previousEnd_ = comment.span.end;
    ++next_;
  }

  /// Comments in the middle of something go before it.
  void commentsInside(Span span, const std::string& indent) {
    while (next_ < parsed_.comments.size() && parsed_.comments[next_].span.begin < span.end) {
      out_ += indent + parsed_.comments[next_].text + "\n";
      ++next_;
    }
  }

  void finish(Span span, std::uint32_t limit) {
    previousEnd_ = span.end;
    trailingComment(span.end > 0 ? span.end - 1 : 0, limit);
    out_ += "\n";
  }

  void printLine(const std::string& text, Span span) {
    commentsInside(span, "");
    out_ += text;
    finish(span, end());
  }

  template <class Clause>
  void printBlock(const std::string& header, Span span, const std::vector<Clause>& clauses,
                  std::uint32_t bodyBegin) {
    const std::uint32_t first = clauses.empty() ? span.end : clauses.front().span.begin;
    out_ += header + " {";
    if (next_ < parsed_.comments.size() && parsed_.comments[next_].span.begin > bodyBegin)
      trailingComment(bodyBegin, first);
    out_ += "\n";
    previousEnd_ = bodyBegin;
    std::size_t width = 0;
    for (const Clause& clause : clauses) {
      const Line l = lineOf(clause);
      if (l.word != "mirror" && l.word != "meta") width = std::max(width, l.word.size());
    }
    for (const Clause& clause : clauses) {
      const Line l = lineOf(clause);
      commentsBefore(clause.span.begin, "  ");
      commentsInside(clause.span, "  ");
      const std::size_t padding = l.word.size() < width && l.word != "mirror" && l.word != "meta"
                                      ? width - l.word.size()
                                      : 0;
      out_ += "  " + l.word + std::string(padding + 1, ' ') + l.rest;
      finish(clause.span, span.end);
    }
    commentsBefore(span.end, "  ");
    out_ += "}";
    finish(span, end());
  }

  /// Where the brace of a block stands, as nearly as its parts tell.
  static std::uint32_t last(const LevelRange& levels) {
    return levels.last.isMissing() ? levels.first.span.end : levels.last.span.end;
  }

  void printRule(const std::string& prefix, const Rule& rule, Span span) {
    printBlock(prefix + ruleHeader(rule), span, rule.clauses, last(rule.levels));
  }

  void printProperty(const Property& p, Span span) {
    std::string header =
        "property " + quoted(p.title.text) + " forall match of " + quoted(p.rule.text);
    if (p.variable)
      header += ", " + p.variable->text + " in " + printExpression(p.first) + ".." +
                printExpression(p.last);
    commentsInside(span, "");
    out_ += header + " {\n";
    for (const Expr& e : p.expectations) out_ += "  expect " + printExpression(e) + ";\n";
    out_ += "}";
    finish(span, end());
  }

  static std::string useText(const Use& use) {
    std::string text = "use " + use.library.text + "." + (use.rule ? quoted(use.rule->text) : "*");
    if (!use.except.empty())
      text += " except " + join(use.except, [](const Name& n) { return quoted(n.text); });
    return text + ";";
  }

  void printContent(const Item& item) {
    std::visit(
        [&](const auto& c) {
          using C = std::decay_t<decltype(c)>;
          if constexpr (std::is_same_v<C, Import>)
            printLine(
                "import " + quoted(c.path.text) + (c.alias ? " as " + c.alias->text : "") + ";",
                item.span);
          else if constexpr (std::is_same_v<C, Use>)
            printLine(useText(c), item.span);
          else if constexpr (std::is_same_v<C, Constant>)
            printLine("const " + c.name.text + " = " + printExpression(c.value) + ";", item.span);
          else if constexpr (std::is_same_v<C, Function> || std::is_same_v<C, Metric>)
            printLine((std::is_same_v<C, Metric> ? "metric " : "def ") + c.name.text + "(" +
                          join(c.parameters, nameOf) + ") = " + printExpression(c.value) + ";",
                      item.span);
          else if constexpr (std::is_same_v<C, RuleSetBlock>)
            printBlock("ruleset " + quoted(c.name.text) +
                           (c.base ? " extends " + quoted(c.base->text) : ""),
                       item.span, c.settings, c.base ? c.base->span.end : c.name.span.end);
          else if constexpr (std::is_same_v<C, Rule>)
            printRule("", c, item.span);
          else if constexpr (std::is_same_v<C, Template>)
            printRule("template " + c.name.text + "(" + join(c.parameters, nameOf) + ") ", c.rule,
                      item.span);
          else if constexpr (std::is_same_v<C, Instance>)
            printLine("rule " + quoted(c.title.text) + " = " + printExpression(c.call) + ";",
                      item.span);
          else if constexpr (std::is_same_v<C, Test>)
            printBlock("test " + quoted(c.title.text), item.span, c.clauses, c.title.span.end);
          else if constexpr (std::is_same_v<C, Property>)
            printProperty(c, item.span);
        },
        item.content);
  }

  static bool isBlock(const Item& item) {
    return std::holds_alternative<RuleSetBlock>(item.content) ||
           std::holds_alternative<Rule>(item.content) ||
           std::holds_alternative<Template>(item.content) ||
           std::holds_alternative<Test>(item.content) ||
           std::holds_alternative<Property>(item.content);
  }

  void printItem(const Item& item) {
    if ((isBlock(item) || wasBlock_) && !out_.ends_with("\n\n")) out_ += "\n";
    commentsBefore(item.span.begin, "");
    // A blank line between a comment and what follows parts the two; doc comments stand close.
    blankLineIfThereWasOne(item.span.begin);
    printContent(item);
    wasBlock_ = isBlock(item);
  }

  const SourceText& source_;
  const ParsedFile& parsed_;
  std::string out_;
  std::size_t next_ = 0;  ///< the next comment
  std::uint32_t previousEnd_ = 0;
  bool wasBlock_ = false;
};

}  // namespace

std::string print(const SourceText& source, const ParsedFile& parsed) {
  return Printer(source, parsed).print();
}

Formatted format(std::string name, std::string text) {
  DiagnosticList list;
  const SourceText source(std::move(name), std::move(text));
  const ParsedFile parsed = parseFile(source, list);
  Formatted result;
  const bool hasErrors = list.hasErrors();
  result.diagnostics = list.take();
  if (!hasErrors) result.text = print(source, parsed);
  return result;
}

}  // namespace af2::dsl
