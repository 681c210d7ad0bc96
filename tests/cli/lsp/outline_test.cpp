// Layout, outline and folding.
#include <gtest/gtest.h>

#include "tests/cli/lsp/conversation.h"
#include "tests/cli/lsp/sample_rules.h"

namespace af2::lsp {
namespace {

TEST(LspFormatting, GivesTheEditsOfTheFormatterAndKeepsLineBreaks) {
  const std::string untidy = "af2 1;\nconst   H=0.866;\n\n\n\nconst G=1;";
  const std::string tidy = "af2 1;\nconst H = 0.866;\n\nconst G = 1;\n";
  Conversation c;
  c.open(untidy);
  Json params = c.paramsOf();
  params["options"] = {{"tabSize", 4}, {"insertSpaces", true}};
  EXPECT_EQ(c.edited(c.request("textDocument/formatting", params)), tidy);
  c.open(replaced(untidy, "\n", "\r\n"));
  EXPECT_EQ(c.edited(c.request("textDocument/formatting", params)), replaced(tidy, "\n", "\r\n"));
  c.open(tidy);
  EXPECT_EQ(c.request("textDocument/formatting", params), Json::array());
  c.open("af2 1;\nconst = ;\n");
  EXPECT_EQ(c.request("textDocument/formatting", params), Json::array());
  c.open(untidy);
  params["range"] = {{"start", {{"line", 1}, {"character", 0}}},
                     {"end", {{"line", 1}, {"character", 3}}}};
  EXPECT_EQ(c.edited(c.request("textDocument/rangeFormatting", params)),
            "af2 1;\nconst H = 0.866;\n\nconst G=1;");
}

TEST(LspOutline, NestsWhatRulesHold) {
  Conversation c(
      R"({"textDocument": {"documentSymbol": {"hierarchicalDocumentSymbolSupport": true}}})");
  c.open(kRules);
  const Json list = c.request("textDocument/documentSymbol", c.paramsOf());
  EXPECT_EQ(valuesOf(list, "name"), (std::vector<std::string>{"H", "push", "good", "right 120",
                                                              "flat {k}", "a corner", "flat"}));
  const auto inner = valuesOf(list[3]["children"], "name");
  for (const char* name : {"c", "d", "left 120"}) EXPECT_TRUE(holds(inner, name)) << name;
  Conversation flat;
  flat.open(kRules);
  EXPECT_TRUE(flat.request("textDocument/documentSymbol", flat.paramsOf())[0].contains("location"));
  EXPECT_EQ(flat.request("workspace/symbol", {{"query", "RIGHT"}}).size(), 1U);
}

TEST(LspOutline, FoldsBlocksAndComments) {
  Conversation c;
  c.open("# one\n# two\n" + kRules);
  const Json folds = c.request("textDocument/foldingRange", c.paramsOf());
  EXPECT_EQ(folds.size(), 6U);
  EXPECT_EQ(folds.back()["kind"], "comment");
}

}  // namespace
}  // namespace af2::lsp
