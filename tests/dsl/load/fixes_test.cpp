#include "dsl/load/fixes.h"

#include <gtest/gtest.h>

namespace af2::dsl {
namespace {

const std::string kHead = "af2 1;\nconst H = 0.866;\nruleset \"r\" { elements tri, quad; }\n";

std::string fixed(const std::string& rules) {
  return fixText("r.af2", kHead + rules).text.substr(kHead.size());
}

void expectSound(const std::string& rules) {
  const LoadedRules loaded = loadRulesFromText("r.af2", kHead + rules);
  EXPECT_TRUE(loaded.diagnostics.empty()) << toPretty(loaded.diagnostics) << rules;
}

TEST(Fixes, TakeTheNamesThatAreMeant) {
  const std::string text = fixed(
      "rule \"x\" quality 1 { # a comment\n"
      "  nwe  c = mid(a, b) + (0, HH);\n"
      "  zone a, b, lrep(mid(a, b), c, 1.1);\n"
      "  tri  a b c;\n}\n");
  EXPECT_EQ(text,
            "rule \"x\" quality 1 { # a comment\n"
            "  new  c = mid(a, b) + (0, H);\n"
            "  zone a, b, lerp(mid(a, b), c, 1.1);\n"
            "  tri  a b c;\n}\n");
}

TEST(Fixes, AddWhatIsMissing) {
  const std::string text = fixed(
      "rule \"x\" quality 1 {\n  new c = mid(a, b) + (0, H)\n  zone a, b, c\n  tri a b c;\n\n"
      "rule \"y\" quality 2 { new c = mid(a, b) + (0, 0.5); zone a, b, c; tri a b c; }\n");
  EXPECT_EQ(
      text,
      "rule \"x\" quality 1 {\n  new c = mid(a, b) + (0, H);\n  zone a, b, c;\n  tri a b c;\n\n"
      "}\n\nrule \"y\" quality 2 { new c = mid(a, b) + (0, 0.5); zone a, b, c; tri a b c; }\n");
  expectSound(text);
}

TEST(Fixes, MendSignsThatAreTooManyOrWrong) {
  const std::string right =
      "rule \"x\" quality 1 {\n  new c = mid(a, b) + (0, H);\n  require c.y == H;\n"
      "  zone a, b, c;\n  tri a b c;\n}\n";
  const auto with = [&](const std::string& part, const std::string& other) {
    std::string text = right;
    return text.replace(text.find(part), part.size(), other);
  };
  EXPECT_EQ(fixed(with("H);", "H);;")), right);
  EXPECT_EQ(fixed(with("H);", "H));")), right);
  EXPECT_EQ(fixed(with("==", "=")), right);
  EXPECT_EQ(fixed(with("tri a b c;\n}", "tri a b c;\n}\n}")).find("}\n}"), std::string::npos);
  EXPECT_EQ(fixed(with("b, c;\n  tri", "b, c;}\n  tri")), right);
  EXPECT_EQ(fixText("r.af2", kHead.substr(7) + right).text, "af2 1;\n\n" + kHead.substr(7) + right);
  EXPECT_NE(fixed(with("tri a b c;\n}\n", "tri a b c;")).find("tri a b c;\n}"), std::string::npos);
}

TEST(Fixes, TurnElementsTheRightWayRound) {
  EXPECT_NE(fixed("rule \"x\" quality 1 { new c = mid(a, b) + (0, H); zone a, b, c; tri a c b; }\n")
                .find("tri a b c;"),
            std::string::npos);
}

TEST(Fixes, FindTheElementThatClosesUp) {
  const std::string text = fixed(
      "rule \"left 120\" quality 1 {\n  front c -> a -> b;\n  at c (-0.5, H);\n  new d = b + (c - "
      "a);\n"
      "  zone a, b, d, c;\n  tri a b d, b c d;\n}\n");
  EXPECT_NE(text.find("tri a b d, a d c;"), std::string::npos) << text;
  EXPECT_NE(text.find("  mirror \"right 120\";\n}"), std::string::npos) << text;
  expectSound(text);
}

/// The element that is written is right; what is missing is another one.
TEST(Fixes, DoNotTakeAnElementWithOtherCornersForASlip) {
  const std::string rule =
      "rule \"x\" quality 1 {\n  front a -> b -> c;\n  at c (1.5, H);\n  new d = a + (c - b);\n"
      "  zone a, b, c, d;\n  tri a b d;\n  tri b c d;\n  mirror \"y\";\n}\n";
  expectSound(rule);
  std::string without = rule;
  without.erase(without.find("  tri b c d;\n"), 13);
  const LoadedRules loaded = loadRulesFromText("r.af2", kHead + without);
  EXPECT_EQ(toPretty(loaded.diagnostics).find("did you mean"), std::string::npos)
      << toPretty(loaded.diagnostics);
  EXPECT_EQ(fixed(without), without);
}

TEST(Fixes, GiveAnglesTheirUnit) {
  const std::string right =
      "rule \"x\" quality 1 {\n  new c = mid(a, b) + (0, sin(60deg));\n  zone a, b, c;\n"
      "  tri a b c;\n}\n";
  std::string bare = right;
  bare.erase(bare.find("deg"), 3);
  EXPECT_EQ(fixed(bare), right);
}

TEST(Fixes, RemoveMirrorsThatDoNothing) {
  EXPECT_EQ(fixed("rule \"x\" quality 1 {\n  new c = mid(a, b) + (0, H);\n  zone a, b, c;\n"
                  "  tri a b c;\n  mirror \"y\";\n}\n"),
            "rule \"x\" quality 1 {\n  new c = mid(a, b) + (0, H);\n  zone a, b, c;\n"
            "  tri a b c;\n}\n");
}

TEST(Fixes, LeaveASoundFileAlone) {
  const std::string sound =
      "rule \"x\" quality 1 { new c = mid(a, b) + (0, H); zone a, b, c; tri a b c; }\n";
  EXPECT_EQ(fixed(sound), sound);
}

TEST(Fixes, NeverMakeAFileWorse) {
  // 'e' is near 'd' and 'c'; neither makes an element that closes up.
  const std::string text =
      "rule \"x\" quality 1 {\n  front a -> b -> c;\n  at c (1, 1);\n  new d = a + (c - b);\n"
      "  zone a, b, c, d;\n  quad a b c e;\n}\n";
  const LoadedRules before = loadRulesFromText("r.af2", kHead + text);
  const LoadedRules after = loadRulesFromText("r.af2", kHead + fixed(text));
  EXPECT_LE(after.diagnostics.size(), before.diagnostics.size());
}

}  // namespace
}  // namespace af2::dsl
