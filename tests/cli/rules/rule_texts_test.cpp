#include "cli/rules/rule_texts.h"

#include <gtest/gtest.h>

#include "cli/rules/rules_location.h"

namespace af2::cli {
namespace {

TEST(RuleTexts, AreThoseOfTheRulesInTheirOrder) {
  const dsl::LoadedRules loaded = dsl::loadRulesFromText("few.af2", R"(af2 1;
ruleset "few" { elements tri; match 0.2; score max of shape_size(10); front by q; }

rule "first" quality 1 {
  new  c = a + (0.5, 0.8);
  zone a, b, c;
  tri  a b c;
}
rule "right" quality 1 {
  front a -> b -> c;
  at    c (0.5, 0.8);
  zone  a, b, c;
  tri   a b c;
  mirror "left";
}
)");
  ASSERT_NE(loaded.rules, nullptr) << dsl::toPretty(loaded.diagnostics);
  const std::vector<geometry::RuleText> texts = ruleTextsOf(loaded);
  ASSERT_EQ(texts.size(), 3u);
  EXPECT_EQ(texts[0].file, "few.af2");
  EXPECT_EQ(texts[0].line, 4);
  EXPECT_EQ(texts[0].text.find("rule \"first\""), 0u);
  EXPECT_EQ(texts[0].text.back(), '}');
  EXPECT_EQ(texts[1].line, 9);
  EXPECT_EQ(texts[2], texts[1]);  // the mirror image
}

TEST(RuleTexts, NameFilesOfAf2RelativeToItsRules) {
  const dsl::LoadedRules loaded = dsl::loadRules(rulesDirectory() / "tri" / "classic.af2");
  EXPECT_EQ(ruleTextsOf(loaded).front().file, "tri/classic.af2");
}

}  // namespace
}  // namespace af2::cli
