#include "dsl/proof/proven_errors.h"

#include <gtest/gtest.h>

namespace af2::dsl {
namespace {

LoadedRules ruleWithZone(const std::string& zone) {
  const LoadedRules loaded = loadRulesFromText("free.af2", R"(af2 1;
ruleset "mine" { elements tri; }
rule "free" quality 1 {
  new  c = mid(a, b) + (0, 0.9);
  zone )" + zone + R"(;
  tri  a b c;
}
)");
  EXPECT_TRUE(loaded.rules) << toPretty(loaded.diagnostics);
  return loaded;
}

TEST(ProvenErrors, AreThoseThatACounterExampleShows) {
  const ProvenErrors errors = findProvenErrors(ruleWithZone("a, b, mid(a, b) + (0, 0.1)"));
  ASSERT_EQ(errors.diagnostics.size(), 1u);
  EXPECT_EQ(idOf(errors.diagnostics.front().code), "Z1");
  EXPECT_EQ(errors.diagnostics.front().severity, Severity::Error);
  EXPECT_EQ(errors.diagnostics.front().place.line, 5);
  ASSERT_EQ(errors.result.answers.size(), 1u);
  EXPECT_EQ(errors.result.answers.front().covered, Answer::Refuted);
}

TEST(ProvenErrors, AreNoneOfASoundRule) {
  const ProvenErrors errors = findProvenErrors(ruleWithZone("a, b, c"));
  EXPECT_TRUE(errors.diagnostics.empty()) << toPretty(errors.diagnostics);
  EXPECT_NE(errors.result.answers.front().covered, Answer::Refuted);
}

}  // namespace
}  // namespace af2::dsl
