// Names that a rule file declares and nothing implements, in an editor.
#include <gtest/gtest.h>

#include "tests/cli/lsp/conversation.h"

namespace af2::lsp {
namespace {

/// A rule file with a mark: | stands where the editor asks.
std::string withExtern(const std::string& before, const std::string& call) {
  return "af2 1;\n## How warm it is.\nextern function " + before +
         "heat(point) : number;\nruleset \"s\" { elements tri; }\n"
         "rule \"free\" quality 1 {\n  new c = mid(a, b) + (0, 0.866);\n  require " +
         call + " < 0.5;\n  zone a, b, c;\n  tri a b c;\n}\n" +
         "test \"t\" {\n  front p (0, 0) -> r (1, 0);\n  expect rule \"free\";\n}\n";
}

TEST(LspExtern, ShowsTheDeclarationWhereANameIsCalled) {
  Conversation c;
  const Json hover = c.requestAt("textDocument/hover", withExtern("", "he|at(c)"));
  const std::string text = hover["contents"]["value"];
  EXPECT_TRUE(says(text, "extern function heat(point) : number;"));
  EXPECT_TRUE(says(text, "How warm it is."));
}

TEST(LspExtern, LeadsToTheDeclaration) {
  Conversation c;
  const Json found = c.requestAt("textDocument/definition", withExtern("", "he|at(c)"));
  EXPECT_TRUE(says(found.dump(), "\"line\":2")) << found;
}

TEST(LspExtern, ShowsTheTypesOfTheArguments) {
  Conversation c;
  const Json help = c.requestAt("textDocument/signatureHelp", withExtern("", "heat(|c)"));
  EXPECT_TRUE(says(help.dump(), "heat(point)")) << help;
}

TEST(LspExtern, IsOfferedByItsName) {
  Conversation c;
  const Json list = c.requestAt("textDocument/completion", withExtern("", "he|at(c)"));
  EXPECT_TRUE(says(list.dump(), "\"heat\"")) << list;
}

TEST(LspExtern, IsNoFaultOfTheFileAndIsNotTested) {
  Conversation c;
  std::string text = withExtern("", "heat(c)");
  c.open(text);
  EXPECT_TRUE(c.diagnostics().empty()) << c.diagnostics();
  const Json params = {{"command", "af2.test"},
                       {"arguments", Json::array({{{"uri", Conversation::kUri}}})}};
  EXPECT_TRUE(says(c.fault("workspace/executeCommand", params), "nothing implements it"));
}

}  // namespace
}  // namespace af2::lsp
