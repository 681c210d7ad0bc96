#include "dsl/format/printer.h"

#include <algorithm>

#include "dsl/format/clause_printer.h"

namespace af2::dsl {
namespace {

/// Writes items with the comments before, between and after them.
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

  /// The position of `af2`, after comments at the beginning of the file.
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

  /// Writes all comments that begin before `offset`, each on its own line.
  void commentsBefore(std::uint32_t offset, const std::string& indent) {
    while (next_ < parsed_.comments.size() && parsed_.comments[next_].span.begin < offset) {
      const Comment& comment = parsed_.comments[next_++];
      blankLineIfThereWasOne(comment.span.begin);
      out_ += indent + comment.text + "\n";
      previousEnd_ = comment.span.end;
    }
  }

  /// Writes a comment on the line where the previous text ended, if it begins before `limit`.
  void trailingComment(std::uint32_t endedAt, std::uint32_t limit) {
    if (next_ >= parsed_.comments.size()) return;
    const Comment& comment = parsed_.comments[next_];
    if (comment.ownLine || comment.span.begin >= limit || line(comment.span.begin) != line(endedAt))
      return;
    out_ += "  " + comment.text;
    previousEnd_ = comment.span.end;
    ++next_;
  }

  /// Comments in the middle of a clause are moved before it.
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

  /// The position of the opening brace of a block, estimated from its parts.
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

  static std::string functionText(const AnyOf<Function, Metric> auto& f) {
    return f.name.text + "(" + join(f.parameters, nameOf) + ") = " + printExpression(f.value) + ";";
  }

  static std::string externText(const Extern& e) {
    std::string text = "extern " + e.kind.text + " " + e.name.text;
    if (e.hasList) text += "(" + join(e.parameters, nameOf) + ")";
    if (e.result) text += " : " + e.result->text;
    return text + ";";
  }

  void printContent(const Item& item) {
    const Span span = item.span;
    match(
        item.content, [](std::monostate) {},
        [&](const Import& c) {
          printLine("import " + quoted(c.path.text) + (c.alias ? " as " + c.alias->text : "") + ";",
                    span);
        },
        [&](const Use& c) { printLine(useText(c), span); },
        [&](const Constant& c) {
          printLine("const " + c.name.text + " = " + printExpression(c.value) + ";", span);
        },
        [&](const Function& c) { printLine("def " + functionText(c), span); },
        [&](const Metric& c) { printLine("metric " + functionText(c), span); },
        [&](const Extern& c) { printLine(externText(c), span); },
        [&](const RuleSetBlock& c) {
          printBlock(
              "ruleset " + quoted(c.name.text) + (c.base ? " extends " + quoted(c.base->text) : ""),
              span, c.settings, c.base ? c.base->span.end : c.name.span.end);
        },
        [&](const Rule& c) { printRule("", c, span); },
        [&](const Template& c) {
          printRule("template " + c.name.text + "(" + join(c.parameters, nameOf) + ") ", c.rule,
                    span);
        },
        [&](const Instance& c) {
          printLine("rule " + quoted(c.title.text) + " = " + printExpression(c.call) + ";", span);
        },
        [&](const Test& c) {
          printBlock("test " + quoted(c.title.text), span, c.clauses, c.title.span.end);
        },
        [&](const Property& c) { printProperty(c, span); });
  }

  static bool isBlock(const Item& item) {
    return match(
        item.content,
        [](const AnyOf<RuleSetBlock, Rule, Template, Test, Property> auto&) { return true; },
        [](const AnyOf<std::monostate, Import, Use, Constant, Function, Metric, Extern,
                       Instance> auto&) { return false; });
  }

  void printItem(const Item& item) {
    if ((isBlock(item) || wasBlock_) && !out_.ends_with("\n\n")) out_ += "\n";
    commentsBefore(item.span.begin, "");
    // A blank line separates a comment from the next item; a doc comment has no blank line after
    // it.
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
