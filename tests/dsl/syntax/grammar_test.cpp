#include "dsl/syntax/grammar.h"

#include <gtest/gtest.h>

#include <random>

namespace af2::dsl {
namespace {

struct Parsed {
  File file;
  std::vector<Diagnostic> diagnostics;
};

Parsed parse(const std::string& text) {
  DiagnosticList list;
  const SourceText source("test.af2", text);
  ParsedFile parsed = parseFile(source, list);
  return {std::move(parsed.file), list.take()};
}

std::vector<std::string> codesAndLines(const Parsed& parsed) {
  std::vector<std::string> result;
  for (const Diagnostic& d : parsed.diagnostics)
    result.push_back(idOf(d.code) + ":" + std::to_string(d.place.line));
  return result;
}

const Expr& constantIn(const Parsed& parsed) {
  return std::get<Constant>(parsed.file.items.at(0).content).value;
}

/// Fully bracketed, so that grouping shows.
std::string bracketed(const Expr& e) {
  switch (e.kind) {
    case ExprKind::Number:
      return e.name;
    case ExprKind::Angle:
      return e.name + "deg";
    case ExprKind::Name:
      return e.name;
    case ExprKind::Imported:
      return e.qualifier + "::" + e.name;
    case ExprKind::Member:
      return bracketed(e.parts[0]) + "." + e.name;
    case ExprKind::Binary:
      return "[" + bracketed(e.parts[0]) + " " + e.name + " " + bracketed(e.parts[1]) + "]";
    case ExprKind::Negate:
      return "[-" + bracketed(e.parts[0]) + "]";
    case ExprKind::Not:
      return "[not " + bracketed(e.parts[0]) + "]";
    case ExprKind::Paren:
      return bracketed(e.parts[0]);
    case ExprKind::In:
      return "[" + bracketed(e.parts[0]) + " in " + bracketed(e.parts[1]) + ".." +
             bracketed(e.parts[2]) + "]";
    default:
      break;
  }
  std::string text = e.qualifier.empty() ? e.name : e.qualifier + "::" + e.name;
  text += "(";
  for (const Expr& part : e.parts) text += (text.back() == '(' ? "" : ", ") + bracketed(part);
  return text + ")";
}

std::string grouping(const std::string& expression) {
  const Parsed parsed = parse("af2 1; const x = " + expression + ";");
  EXPECT_TRUE(parsed.diagnostics.empty()) << expression << "\n" << toPretty(parsed.diagnostics);
  return bracketed(constantIn(parsed));
}

TEST(Grammar, GroupsOperatorsByPrecedence) {
  EXPECT_EQ(grouping("1 + 2*3 - 4/5"), "[[1 + [2 * 3]] - [4 / 5]]");
  EXPECT_EQ(grouping("-2^2"), "[-[2 ^ 2]]");
  EXPECT_EQ(grouping("2^-1"), "[2 ^ [-1]]");
  EXPECT_EQ(grouping("2^3^2"), "[2 ^ [3 ^ 2]]");
  EXPECT_EQ(grouping("a or b and not c < d"), "[a or [b and [not [c < d]]]]");
  EXPECT_EQ(grouping("t in 1..30"), "[t in 1..30]");
  EXPECT_EQ(grouping("c.y*2 + lib.H"), "[[c.y * 2] + lib::H]");
  EXPECT_EQ(grouping("lib.f(1, a)"), "lib::f(1, a)");
  EXPECT_EQ(grouping("turn(b)/90deg"), "[turn(b) / 90deg]");
}

TEST(Grammar, ReadsNumbersStrictly) {
  EXPECT_EQ(grouping(".5"), ".5");
  EXPECT_EQ(grouping("2e-3"), "2e-3");
  for (const char* bad : {"1e", "1.2.3", "1.", "2x", "0x10", "1e999"}) {
    const Parsed parsed = parse(std::string("af2 1;\nconst x = ") + bad + ";");
    EXPECT_EQ(codesAndLines(parsed), std::vector<std::string>{"L2:2"}) << bad;
  }
}

TEST(Grammar, TellsEveryBrokenClauseOnceOnItsLine) {
  const Parsed parsed = parse(R"(af2 1;
const H = ;
rull "x" quality 1 { tri a b c; }
rule "y" quality 1 {
  new c = a + (0, H)
  zone a, b, c;
  frnt a -> b;
  require 1 < 2 < 3;
  zone a => b => c;
  at c (1, 2;
}
rule "z" {
  tri a b c;
}
test "t" {
  expect;
}
)");
  const std::vector<std::string> expected{"S3:2", "S4:3",  "S2:5",  "S4:7", "S1:8",
                                          "S8:9", "S1:10", "S1:12", "S1:16"};
  EXPECT_EQ(codesAndLines(parsed), expected) << toPretty(parsed.diagnostics);
}

TEST(Grammar, KeepsReadingBehindABlockThatIsNotClosed) {
  const Parsed parsed =
      parse("af2 1;\nrule \"a\" quality 1 {\n tri a b c;\nrule \"b\" quality 1 { tri a b c; }\n");
  ASSERT_EQ(codesAndLines(parsed), std::vector<std::string>{"S5:4"});
  EXPECT_TRUE(std::holds_alternative<Rule>(parsed.file.items.back().content));
}

TEST(Grammar, WantsTheVersionFirst) {
  EXPECT_EQ(codesAndLines(parse("const H = 1;")), std::vector<std::string>{"S7:1"});
  EXPECT_EQ(codesAndLines(parse("af2 2; const H = 1;")), std::vector<std::string>{"S7:1"});
}

TEST(Grammar, DocumentsWhatFollows) {
  const Parsed parsed =
      parse("af2 1;\n## First line\n## second.\nrule \"r\" quality 1 { tri a b c; }\n");
  EXPECT_EQ(std::get<Rule>(parsed.file.items.at(0).content).doc, "First line\nsecond.");
}

TEST(Grammar, RefusesWhatIsNestedTooDeep) {
  const std::string deep =
      "af2 1; const x = " + std::string(100000, '(') + "1" + std::string(100000, ')') + ";";
  EXPECT_EQ(codesAndLines(parse(deep)), std::vector<std::string>{"S6:1"});
  std::string longSum = "af2 1; const x = 1";
  for (int i = 0; i < 100000; ++i) longSum += "+1";
  EXPECT_EQ(codesAndLines(parse(longSum + ";")), std::vector<std::string>{"S6:1"});
  std::string powers = "af2 1; const x = 2";
  for (int i = 0; i < 100000; ++i) powers += "^2";
  EXPECT_EQ(codesAndLines(parse(powers + ";")), std::vector<std::string>{"S6:1"});
}

TEST(Grammar, SurvivesGarbage) {
  const std::vector<std::string> pieces{
      "rule", "\"x\"", "quality", "1",      "{",       "}",   "(",      ")",   ";",
      ",",    "->",    "=>",      "zone",   "at",      "new", "c",      "=",   "..",
      "tri",  "test",  "expect",  "front",  "ruleset", "for", "in",     "def", "const",
      "#",    "\n",    "\"",      "1.",     "~",       "any", "mirror", "if",  "then",
      "\xff", "@",     "metric",  "import", "use",     "."};
  std::mt19937 random(7);
  for (int i = 0; i < 3000; ++i) {
    std::string text = i % 3 ? "af2 1;" : "";
    for (unsigned k = random() % 60; k > 0; --k) text += pieces[random() % pieces.size()] + " ";
    const Parsed parsed = parse(text);
    EXPECT_LE(parsed.diagnostics.size(), DiagnosticList::kMax);
  }
}

}  // namespace
}  // namespace af2::dsl
