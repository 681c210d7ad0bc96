// What is told of a word.
#include <gtest/gtest.h>

#include "tests/cli/lsp/conversation.h"
#include "tests/cli/lsp/sample_rules.h"

namespace af2::lsp {
namespace {

std::string hoverAt(const std::string& marked, Json options = Json::object()) {
  Conversation c("{}", std::move(options));
  const Json hover = c.requestAt("textDocument/hover", marked);
  return hover.is_object() ? hover["contents"]["value"].get<std::string>() : "";
}

TEST(LspHover, ARuleShowsItsDocItsPictureAndWhatFollows) {
  const std::string text = hoverAt(at("right 120"));
  EXPECT_TRUE(says(text, "Two triangles fill the corner."));
  EXPECT_TRUE(says(text, "consumed edges: a -> b -> c"));
  EXPECT_TRUE(says(text, "kept edges: none"));
  EXPECT_TRUE(says(text, "new edges: a -> d -> c"));
  EXPECT_TRUE(says(text, "makes: 2 triangles"));
  EXPECT_TRUE(says(text, "tests that name it: 1"));
  EXPECT_TRUE(says(text, "](data:image/svg+xml;base64,PD94bWwg"));  // <?xml
  EXPECT_LT(text.size(), 100'000U);                                 // more is cut by VS Code
}

TEST(LspHover, PicturesCanBeSwitchedOff) {
  EXPECT_FALSE(says(hoverAt(at("right 120"), {{"hoverPictures", false}}), "data:"));
}

TEST(LspHover, NamesShowTheirDefinition) {
  EXPECT_TRUE(says(hoverAt(at("push(b")), "def push(o, p, r, k) = lerp(o, mid(p, r), k);"));
  EXPECT_TRUE(says(hoverAt(at("push(b")), "Beyond the middle."));
  EXPECT_TRUE(says(hoverAt(at("H);")), "= 0.866"));
  EXPECT_TRUE(says(hoverAt(at("H);")), "The height of the ideal triangle."));
  EXPECT_TRUE(says(hoverAt(at("d, b c d")), "new vertex d = a + (c - b)"));
  EXPECT_TRUE(says(hoverAt(at("m + (0")), "let m = mid(a, b)"));
  EXPECT_TRUE(says(hoverAt(at("height);")), "parameter height"));
  EXPECT_TRUE(says(hoverAt(at("\"flat 5\"")), "2 rules, one for each tuple"));
}

TEST(LspHover, WordsOfTheLanguageAreExplained) {
  EXPECT_TRUE(says(hoverAt(at("lerp")), "lerp(from, to, t)"));
  EXPECT_TRUE(says(hoverAt(at("zone  a")), "The free zone"));
  EXPECT_EQ(hoverAt(at("# The height", 1, 6)), "");
}

TEST(LspHover, WorksWhileOtherRulesAreBroken) {
  std::string text = at("right 120");
  text += "rule \"half\" quality 1 {\n  new c = \n}\n";
  EXPECT_TRUE(says(hoverAt(text), "new edges: a -> d -> c"));
}

TEST(LspHover, PlainTextForEditorsWithoutMarkdown) {
  Conversation c(R"({"textDocument": {"hover": {"contentFormat": ["plaintext"]}}})");
  const Json hover = c.requestAt("textDocument/hover", at("H);"));
  EXPECT_EQ(hover["contents"]["kind"], "plaintext");
  EXPECT_FALSE(says(hover["contents"]["value"], "```"));
}

}  // namespace
}  // namespace af2::lsp
