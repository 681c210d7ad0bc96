#include <gtest/gtest.h>

#include <algorithm>

#include "dsl/load/loaded_file.h"
#include "dsl/load/rule_file.h"
#include "dsl/symbols/block_context.h"
#include "dsl/symbols/symbol_index.h"

namespace af2::dsl {
namespace {

TEST(Titles, OfFamiliesAreFoundAgain) {
  EXPECT_TRUE(isTitleOf("flat {k}", "flat 5"));
  EXPECT_TRUE(isTitleOf("{k} of {n}", "1 of 12"));
  EXPECT_TRUE(isTitleOf("plain", "plain"));
  EXPECT_FALSE(isTitleOf("flat {k}", "flad 5"));
  EXPECT_FALSE(isTitleOf("flat {k}", "flat "));
  EXPECT_FALSE(isTitleOf("{k} of {n}", "1 in 12"));
  EXPECT_FALSE(isTitleOf("plain", "plainly"));
}

TEST(Titles, OfFamiliesAreRenamedForTheSameValues) {
  EXPECT_EQ(retitled("flat {k}", "flat 5", "{k} low"), "5 low");
  EXPECT_EQ(retitled("{k} of {n}", "1 of 12", "{n}/{k}"), "12/1");
  EXPECT_EQ(titleParameters("{n} of {k}, {n}"), (std::vector<std::string>{"k", "n"}));
}

/// The index of a text, with questions in terms of the text.
class Indexed {
 public:
  explicit Indexed(const std::string& text)
      : loaded_(loadRulesFromText("test.af2", text)), index_(loaded_.file->modules) {}

  const Module& main() const { return loaded_.file->main(); }
  const SymbolIndex& index() const { return index_; }

  /// Where the n-th occurrence of a word leads to: "kind name", or nothing.
  std::string at(const std::string& word, int n = 1) const {
    const auto found = index_.at(main(), offsetOf(word, n));
    if (!found) return "";
    const Symbol& s = index_[found->symbol];
    return std::string(wordFor(s.kind)) + " " + s.name;
  }

  std::size_t usesOf(const std::string& word, int n = 1) const {
    const auto found = index_.at(main(), offsetOf(word, n));
    return static_cast<std::size_t>(
        std::ranges::count(index_.occurrencesIn(main()), found->symbol, &Occurrence::symbol));
  }

 private:
  std::uint32_t offsetOf(const std::string& word, int n) const {
    std::size_t at = main().source.text().find(word);
    for (int i = 1; i < n; ++i) at = main().source.text().find(word, at + 1);
    return static_cast<std::uint32_t>(at);
  }

  LoadedRules loaded_;
  SymbolIndex index_;
};

const char* const kText = R"(af2 1;
const H = 0.8;
metric odd(w, u, v, x) = w * dist(u, v) + dist(v, x);
template corner(angle) rule "corner" quality 1 {
  front a -> b -> c;
  at c (1 - cos(angle), sin(angle));
  zone a, b, c;
  tri a b c;
  mirror "corner, left";
}
ruleset "base" { score max of odd(1); }
ruleset "mine" extends "base" { accept score < H; }
rule "sharp" = corner(50deg);
test "t" {
  front p (0, 0) -> r (1, 0) -> s (0.5, H);
  base p -> r;
  expect rule "sharp" with c = s;
}
property "p" forall match of "sharp", k in 1..3 { expect dist(a, b) < k; }
)";

TEST(SymbolIndex, KnowsNamesByTheBlockTheyStandIn) {
  const Indexed text(kText);
  EXPECT_EQ(text.at("odd(1"), "metric odd");
  EXPECT_EQ(text.at("w * dist"), "parameter w");
  EXPECT_EQ(text.at("angle)", 2), "parameter angle");
  EXPECT_EQ(text.at("corner(50"), "template corner");
  EXPECT_EQ(text.at("\"base\" {"), "rule set base");
  EXPECT_EQ(text.usesOf("\"base\""), 2U);
  EXPECT_EQ(text.at("\"sharp\" with"), "rule sharp");
  EXPECT_EQ(text.usesOf("\"sharp\""), 3U);
  EXPECT_EQ(text.at("s;"), "vertex of the test s");
  EXPECT_EQ(text.at("H;"), "const H");
  EXPECT_EQ(text.at("k;"), "parameter k");
  EXPECT_EQ(text.at("front"), "");
}

TEST(SymbolIndex, KnowsWhichTestsNameARule) {
  const Indexed text(kText);
  for (std::size_t i = 0; i < text.index().symbols().size(); ++i)
    if (text.index()[i].name == "sharp") {
      EXPECT_EQ(text.index().testsOf(i).size(), 2U);
    }
}

TEST(SymbolIndex, KeepsWhatCouldBeRead) {
  const Indexed text(
      "af2 1;\nconst H = 1;\nrule \"x\" quality 1 {\n  new d = ;\n  zone a, H;\n}\n");
  EXPECT_EQ(text.at("H;"), "const H");
}

TEST(SymbolIndex, TellsWhatIsVisible) {
  const Indexed text(kText);
  const std::string_view source = text.main().source.text();
  const auto place = static_cast<std::uint32_t>(source.find("zone a"));
  std::vector<std::string> names;
  for (const std::size_t i : text.index().visibleAt(text.main(), place))
    names.push_back(text.index()[i].name);
  for (const char* name : {"a", "b", "c", "angle", "H", "odd"})
    EXPECT_NE(std::ranges::find(names, name), names.end()) << name;
  EXPECT_EQ(std::ranges::find(names, "w"), names.end());
  EXPECT_EQ(std::ranges::find(names, "s"), names.end());
}

BlockContext contextAtMark(std::string text) {
  const std::size_t mark = text.find('|');
  text.erase(mark, 1);
  return contextAt(SourceText("test.af2", text), static_cast<std::uint32_t>(mark));
}

TEST(BlockContext, IsToldFromHalfWrittenText) {
  const std::string rule =
      "af2 1;\nrule \"x\" quality 1 {\n  front a -> b -> c;\n  let m = mid(a, b)\n";
  const BlockContext clause = contextAtMark(rule + "  zo|");
  EXPECT_EQ(clause.block, BlockKind::Rule);
  EXPECT_EQ(clause.title, "x");
  EXPECT_FALSE(clause.isAtBeginning());  // the ';' before it is missing
  EXPECT_TRUE(contextAtMark(rule + ";\n  zo|").isAtBeginning());

  const BlockContext call = contextAtMark(rule + "  new d = lerp(a, (1, 2), |\n  zone a;\n}\n");
  EXPECT_TRUE(call.begins("new"));
  ASSERT_EQ(call.calls.size(), 1U);
  EXPECT_EQ(call.calls[0].name, "lerp");
  EXPECT_EQ(call.calls[0].argument, 2U);
  std::vector<std::string> names;
  for (const LocalName& n : call.names) names.push_back(n.name);
  EXPECT_EQ(names, (std::vector<std::string>{"a", "b", "c", "m", "d"}));

  // A block that is not closed ends where the next item begins.
  EXPECT_EQ(contextAtMark(rule + "\ntest \"t\" {\n  |").block, BlockKind::Test);
  EXPECT_EQ(contextAtMark(rule + "\nconst H = |").block, BlockKind::File);
}

TEST(BlockContext, KnowsStringsAndComments) {
  EXPECT_TRUE(contextAtMark("af2 1;\n# no|te\n").isInComment);
  EXPECT_TRUE(contextAtMark("af2 1;\nimport \"li|b\";").isInString);
  EXPECT_TRUE(contextAtMark("af2 1;\nimport \"li|").isInString);
  EXPECT_FALSE(contextAtMark("af2 1;\nimport \"lib\"|").isInString);
  EXPECT_FALSE(contextAtMark("af2 1;\nimport |\"lib\"").isInString);
}

}  // namespace
}  // namespace af2::dsl
