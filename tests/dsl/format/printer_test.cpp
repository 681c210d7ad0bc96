#include "dsl/format/printer.h"

#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>

namespace af2::dsl {
namespace {

std::string formatted(const std::string& text) {
  const Formatted result = format("test.af2", text);
  EXPECT_TRUE(result.diagnostics.empty()) << toPretty(result.diagnostics) << text;
  return result.text;
}

/// The words of a text without comments: what parsing sees.
std::string words(const std::string& text) {
  DiagnosticList list;
  const SourceText source("test.af2", text);
  std::string result;
  for (const Token& token : readTokens(source, list).tokens)
    result +=
        (token.is("class") ? "q" : token.text) + (token.kind == TokenKind::String ? "\"\n" : "\n");
  return result;
}

std::vector<std::string> comments(const std::string& text) {
  DiagnosticList list;
  const SourceText source("test.af2", text);
  std::vector<std::string> result;
  for (const Comment& comment : readTokens(source, list).comments) result.push_back(comment.text);
  return result;
}

TEST(Printer, WritesOneClausePerLinePaddedToOneColumn) {
  EXPECT_EQ(formatted(R"(af2 1; const H=.5;
rule "r"   quality 1..3{at c(0.5,H)~ (1,0,2),d (0,1)~any; # expected here
  front a->b->c,d->a; zone a , b,lerp( a,b,2*class+1 )=>c when q<3;tri a b c;
mirror "l"{at c~1;quality 2;}}
)"),
            R"(af2 1;
const H = .5;

rule "r" quality 1..3 {
  at    c (0.5, H) ~ (1, 0, 2), d (0, 1) ~ any;  # expected here
  front a -> b -> c, d -> a;
  zone  a, b, lerp(a, b, 2*q + 1) => c when q < 3;
  tri   a b c;
  mirror "l" { at c ~ 1; quality 2; }
}
)");
}

const char* const kAll = R"(# opens the file
af2 1;  # version
import "lib.af2" as lib;
use lib.* except "x \"y\"", "z";

# about H
const H = sqrt(3)/2;    # height
## documented
def f(p, q1) = if p.x < 1 and not q1 == 2 then -p.y^2 else (1 + 2)*3;
metric m(w, u, v, x) = w*dist(u, v)/dist(v, x);
ruleset "s" extends "t" {
  # inside
  elements tri, quad; match 0.5 + 0.3*class; fade 1/q; score sum of m(2);
  accept score < 2; front by q + layer(a), len(b - a); classes 1..30;
  scale base; parity even;
  meta { author "me"; }
  # last
}
ruleset "t" { front rows(start: smallest_turn); }
template t(k) rule "t {k}" quality k { new c = a + (0, k); zone disc(a, 1) | (disc(b, 1) => disc(b, 0)); tri a b c; }
rule "t5" = t(5);
rule "fam {k}" for (k, z) in (1, 2), (3, 4) quality k .. 30 { new c = a + (0, z); slope a -> b ~ 2; let m2 = mid(a, b);
  require turn(a) in 60deg..125deg, on_boundary(b); cost 0.1*q; priority -2;
  zone poly(a, b, arc(c + (0.4, 0.5) => c, c)); tri a b c, a c b; poly a b c c; }
test "x" { front p (0, 0) -> r (1, 0) -> p; point s (1, 2); base p -> r; class 3; size 2;
  expect rule "t5" with c = s; expect not rule "t5" because zone hit by edge p -> r; expect new 1 at (1, 2);
  expect front only p -> new 1 -> r; expect elements 2; expect stuck; expect score <= 3; expect dist(p, s) > 1; }
property "y" forall match of "t5", q1 in 1..5 { expect dist(a, b) > 0; }
# ends the file
)";

TEST(Printer, KeepsEveryWordAndEveryComment) {
  const std::string once = formatted(kAll);
  EXPECT_EQ(words(once), words(kAll)) << once;
  EXPECT_EQ(comments(once), comments(kAll)) << once;
}

TEST(Printer, IsIdempotent) {
  const std::string once = formatted(kAll);
  EXPECT_EQ(formatted(once), once);
}

TEST(Printer, LeavesTheClassicalRulesAsTheyRead) {
  std::ifstream file(AF2_SOURCE_DIR "/rules/tri/classic.af2");
  std::stringstream text;
  text << file.rdbuf();
  const std::string once = formatted(text.str());
  EXPECT_EQ(words(once), words(text.str()));
  EXPECT_EQ(formatted(once), once);
}

TEST(Printer, HoldsForScatteredBlanksAndComments) {
  DiagnosticList list;
  const SourceText source("test.af2", kAll);
  const TokenList tokens = readTokens(source, list);
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i) {
    std::string text;
    std::size_t begin = 0;
    for (const Token& token : tokens.tokens) {
      text += std::string(kAll).substr(token.span.begin, token.span.end - token.span.begin);
      begin = token.span.end;
      switch (random() % 8) {
        case 0:
          text += "\n";
          break;
        case 1:
          text += "\n\n  ";
          break;
        case 2:
          text += " # note " + std::to_string(random() % 9) + "\n";
          break;
        case 3:
          text += "\n# own line\n";
          break;
        default:
          text += " ";
          break;
      }
    }
    // What was one word must stay one: `60deg`, `1..30`, `a.x` survive blanks.
    const Formatted once = format("test.af2", text);
    ASSERT_TRUE(once.diagnostics.empty()) << toPretty(once.diagnostics);
    EXPECT_EQ(words(once.text), words(text));
    std::vector<std::string> before = comments(text), after = comments(once.text);
    EXPECT_EQ(before, after) << text << "\n------\n" << once.text;
    EXPECT_EQ(formatted(once.text), once.text) << once.text;
    if (HasFailure()) return;
    (void)begin;
  }
}

TEST(Printer, LeavesBrokenTextAlone) {
  const Formatted result = format("test.af2", "af2 1;\nconst = 3;\n");
  EXPECT_TRUE(result.text.empty());
  ASSERT_EQ(result.diagnostics.size(), 1u);
}

}  // namespace
}  // namespace af2::dsl
