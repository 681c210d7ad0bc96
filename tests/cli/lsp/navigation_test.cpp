// Where a name is defined and used, and renaming it.
#include <gtest/gtest.h>

#include "tests/cli/lsp/conversation.h"
#include "tests/cli/lsp/sample_rules.h"

namespace af2::lsp {
namespace {

int definitionLine(const std::string& marked) {
  Conversation c;
  const Json location = c.requestAt("textDocument/definition", marked);
  return location.is_object() ? location["range"]["start"]["line"].get<int>() : -1;
}

TEST(LspDefinition, LeadsFromEveryKindOfUse) {
  EXPECT_EQ(definitionLine(at("push(b")), lineOf("def push"));
  EXPECT_EQ(definitionLine(at("H);")), lineOf("const H"));
  EXPECT_EQ(definitionLine(at("c ~ 2")), lineOf("at    c"));
  EXPECT_EQ(definitionLine(at("c = s")), lineOf("at    c"));
  EXPECT_EQ(definitionLine(at("s;")), lineOf("front  p"));
  EXPECT_EQ(definitionLine(at("d, b c d")), lineOf("new   d"));
  EXPECT_EQ(definitionLine(at("\"right 120\" with")), lineOf("rule \"right 120\" quality"));
  EXPECT_EQ(definitionLine(at("\"flat 5\"")), lineOf("rule \"flat"));
  EXPECT_EQ(definitionLine(at("{k}", 1, 1)), lineOf("for (k"));
  EXPECT_EQ(definitionLine(at("k)", 2)), lineOf("def push"));
  EXPECT_EQ(definitionLine(at("elements")), -1);
}

TEST(LspDefinition, LeadsIntoImportedFiles) {
  const Folder folder;
  const std::string lib = folder.write("lib.af2", "af2 1;\n\nconst G = 0.5;\n");
  const std::string text = "af2 1;\nimport \"lib.af2\" as lib;\nconst H = 2 * lib.G;\n";
  const std::string uri = folder.uri("main.af2");
  Conversation c;
  c.open(text, uri);
  const auto ask = [&](int line, int character) {
    Json params = c.paramsOf(uri);
    params["position"] = {{"line", line}, {"character", character}};
    return c.request("textDocument/definition", params);
  };
  EXPECT_EQ(ask(2, 18)["uri"], lib);
  EXPECT_EQ(ask(2, 18)["range"]["start"]["line"], 2);
  EXPECT_EQ(ask(1, 10)["uri"], lib);
  EXPECT_EQ(ask(2, 15)["uri"], uri);  // the name of the import
  EXPECT_EQ(c.request("textDocument/documentLink", c.paramsOf(uri))[0]["target"], lib);
}

TEST(LspReferences, FindDefinitionAndUses) {
  Conversation c;
  const Json all = c.requestAt("textDocument/references", at("c = s"),
                               {{"context", {{"includeDeclaration", true}}}});
  // front, at, new, zone twice, tri, mirror, with: of this rule alone
  EXPECT_EQ(all.size(), 8U);
  const Json uses = c.requestAt("textDocument/references", at("H);"),
                                {{"context", {{"includeDeclaration", false}}}});
  EXPECT_EQ(uses.size(), 1U);
  EXPECT_EQ(c.requestAt("textDocument/documentHighlight", at("m = mid")).size(), 2U);
}

std::string renamed(const std::string& marked, const std::string& name) {
  Conversation c;
  const Json answer = c.ask("textDocument/rename", c.paramsAt(marked, {{"newName", name}}));
  if (answer.contains("error")) return answer["error"]["message"];
  return c.edited(answer["result"]);
}

TEST(LspRename, ChangesEveryPlaceAndNoOther) {
  EXPECT_EQ(renamed(at("push(b"), "beyond"), replaced(kRules, "push", "beyond"));
  EXPECT_EQ(renamed(at("H);"), "HEIGHT"),
            replaced(replaced(kRules, "const H", "const HEIGHT"), "H);", "HEIGHT);"));
  EXPECT_EQ(renamed(at("m + (0"), "middle"),
            replaced(replaced(kRules, "m = mid", "middle = mid"), "m + (0", "middle + (0"));
  EXPECT_EQ(renamed(at("s;"), "far"),
            replaced(replaced(kRules, "s (1.5", "far (1.5"), "= s;", "= far;"));
  EXPECT_EQ(renamed(at("right 120"), "corner"), replaced(kRules, "\"right 120\"", "\"corner\""));
  EXPECT_EQ(renamed(at("left 120"), "say \"l\""),
            replaced(kRules, "\"left 120\"", "\"say \\\"l\\\"\""));
  const std::string k = renamed(at("k)", 2), "share");
  EXPECT_TRUE(says(k, "def push(o, p, r, share) = lerp(o, mid(p, r), share);"));
  EXPECT_TRUE(says(k, "rule \"flat {k}\" for (k, height)"));
}

TEST(LspRename, FollowsParametersIntoTitlesAndTitlesOfFamiliesIntoTests) {
  EXPECT_TRUE(
      says(renamed(at("for (k", 1, 5), "level"),
           "rule \"flat {level}\" for (level, height) in (5, 0.5), (10, 0.3) quality level"));
  const std::string text = renamed(at("flat {k}"), "{k} low");
  EXPECT_TRUE(says(text, "rule \"{k} low\""));
  EXPECT_TRUE(says(text, "expect rule \"5 low\";"));
  EXPECT_TRUE(says(renamed(at("flat {k}"), "low"), "must contain the same"));
}

TEST(LspRename, RefusesWithWordsThatHelp) {
  EXPECT_TRUE(says(renamed(at("push(b"), "mid"), "'mid' is a function of the language"));
  EXPECT_TRUE(says(renamed(at("H);"), "front"), "'front' is a keyword"));
  EXPECT_TRUE(says(renamed(at("H);"), "2x"), "is not a name"));
  EXPECT_TRUE(says(renamed(at("H);"), "q"), "is the quality level"));
  EXPECT_TRUE(says(renamed(at("H);"), "d"), "already the name of a new vertex here (line 16)"));
  EXPECT_TRUE(says(renamed(at("d, b c d"), "c"), "already the name of a vertex here"));
  EXPECT_TRUE(says(renamed(at("d, b c d"), "a"), "an end of the base edge"));
  EXPECT_TRUE(says(renamed(at("b -> c;"), "x"), "keeps its name"));
  EXPECT_TRUE(says(renamed(at("right 120"), "left 120"), "there is already a rule \"left 120\""));
  EXPECT_TRUE(says(renamed(at("right 120"), "flat 7"), "there is already a rule \"flat {k}\""));
  EXPECT_TRUE(says(renamed(at("right 120"), ""), "a title must be one line of text"));
  EXPECT_TRUE(says(renamed(at("lerp"), "x"), "no name here"));
}

TEST(LspRename, PrepareTellsWhatWouldChange) {
  Conversation c;
  const Json answer = c.requestAt("textDocument/prepareRename", at("\"right 120\" with"));
  EXPECT_EQ(answer["placeholder"], "right 120");
  const Json& range = answer["range"];
  EXPECT_EQ(range["end"]["character"].get<int>() - range["start"]["character"].get<int>(), 9);
}

TEST(LspRename, ReachesFilesThatAreNotOpen) {
  const Folder folder;
  const std::string lib = folder.write("lib.af2", "af2 1;\nconst G = 0.5;\n");
  const std::string user =
      folder.write("user.af2", "af2 1;\nimport \"lib.af2\" as lib;\nconst H = lib.G;\n");
  folder.write("other.af2", "af2 1;\nconst G = 3;\n");
  Conversation c;
  c.session.client.folders = {folder.path()};
  c.open("af2 1;\nconst G = 0.5;\n", lib);
  Json params = c.paramsOf(lib);
  params["position"] = {{"line", 1}, {"character", 6}};
  params["newName"] = "HALF";
  const Json changes = c.request("textDocument/rename", params)["changes"];
  EXPECT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes[user][0]["range"]["start"], Json({{"line", 2}, {"character", 14}}));
}

}  // namespace
}  // namespace af2::lsp
