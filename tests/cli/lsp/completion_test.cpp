// What may come next.
#include <gtest/gtest.h>

#include "tests/cli/lsp/conversation.h"
#include "tests/cli/lsp/sample_rules.h"

namespace af2::lsp {
namespace {

std::vector<std::string> completed(const std::string& marked) {
  Conversation c;
  return valuesOf(c.requestAt("textDocument/completion", marked)["items"], "label");
}

/// kRules with a half-written line before the one that begins with `before`.
std::string typing(const std::string& line, const std::string& before) {
  std::string text = kRules;
  return text.insert(text.find(before), line + "\n  ");
}

TEST(LspCompletion, OffersTheWordsThatFitToTheBlock) {
  EXPECT_TRUE(holds(completed(kRules + "|"), "ruleset"));
  EXPECT_FALSE(holds(completed(kRules + "|"), "zone"));
  const auto inRule = completed(typing("zo|", "zone  a"));
  EXPECT_TRUE(holds(inRule, "zone"));
  EXPECT_FALSE(holds(inRule, "ruleset"));
  EXPECT_FALSE(holds(inRule, "expect"));
  EXPECT_TRUE(holds(completed(typing("|", "elements tri")), "accept"));
  EXPECT_TRUE(holds(completed(typing("ex|", "expect rule \"right")), "expect"));
  EXPECT_TRUE(completed(at("The height", 1, 4)).empty());
}

TEST(LspCompletion, OffersNamesInScope) {
  const auto names = completed(typing("require dist(|", "tri   a b d"));
  for (const char* name : {"a", "b", "c", "d", "H", "push", "dist", "q"})
    EXPECT_TRUE(holds(names, name)) << name;
  EXPECT_FALSE(holds(names, "m"));       // of another rule
  EXPECT_FALSE(holds(names, "height"));  // a parameter of another rule
  const auto vertices = completed(typing("tri a b |", "mirror \"left"));
  EXPECT_EQ(vertices, (std::vector<std::string>{"a", "b", "c", "d"}));
  EXPECT_TRUE(holds(completed(at("height);")), "height"));
}

TEST(LspCompletion, OffersTitlesWhereRulesAreNamed) {
  const auto titles = completed(at("right 120\" with"));
  for (const char* title : {"right 120", "left 120", "flat 5", "flat 10"})
    EXPECT_TRUE(holds(titles, title)) << title;
  EXPECT_EQ(titles.size(), 4U);
  Conversation c;
  const Json items = c.requestAt("textDocument/completion", at("right 120\" with", 1, 3))["items"];
  EXPECT_EQ(items[0]["textEdit"]["range"]["start"]["character"], 15);
  EXPECT_EQ(completed(at("c = s")), (std::vector<std::string>{"a", "b", "c"}));
}

TEST(LspCompletion, OffersOutcomesReasonsAndSettings) {
  EXPECT_TRUE(holds(completed(typing("expect |", "expect rule \"right")), "stuck"));
  EXPECT_TRUE(holds(
      completed(typing("expect not rule \"flat 5\" because |", "expect rule \"right")), "beaten"));
  EXPECT_EQ(completed(typing("scale |", "elements")), (std::vector<std::string>{"h", "base"}));
  EXPECT_TRUE(holds(completed(typing("score max of |", "elements")), "shape_size"));
  EXPECT_EQ(completed(typing("elements |", "elements")),
            (std::vector<std::string>{"tri", "quad", "poly"}));
  EXPECT_EQ(completed(typing("front rows(start: |", "elements")),
            (std::vector<std::string>{"smallest_turn", "oldest"}));
  EXPECT_TRUE(
      holds(completed(typing("expect not rule \"flat 5\" because |", "expect rule \"right")),
            "convexity"));
}

TEST(LspCompletion, OffersFilesAndTheNamesOfImports) {
  const Folder folder;
  folder.write("lib.af2", "af2 1;\nconst G = 0.5;\ndef f(x) = x;\n");
  const std::string uri = folder.uri("main.af2");
  const auto ask = [&](const std::string& marked) {
    const Marked m(marked);
    Conversation c;
    c.open(m.text, uri);
    Json params = c.paramsOf(uri);
    params["position"] = c.session.map(m.text).position(m.offset);
    return valuesOf(c.request("textDocument/completion", params)["items"], "label");
  };
  const auto files = ask("af2 1;\nimport \"|\n");
  EXPECT_TRUE(holds(files, "lib.af2"));
  EXPECT_TRUE(holds(files, "tri/"));
  EXPECT_TRUE(holds(files, "std/quality.af2"));
  EXPECT_TRUE(holds(ask("af2 1;\nimport \"tri/|\";\n"), "classic.af2"));
  const std::string head = "af2 1;\nimport \"lib.af2\" as lib;\n";
  EXPECT_EQ(ask(head + "const H = lib.|;\n"), (std::vector<std::string>{"G", "f"}));
  EXPECT_EQ(ask(head + "use |;\n"), std::vector<std::string>{"lib"});
}

TEST(LspCompletion, FillsInSkeletonsWhereTheEditorCan) {
  Conversation c(
      R"({"textDocument": {"completion": {"completionItem": {"snippetSupport": true}}}})");
  const Json items = c.requestAt("textDocument/completion", "af2 1;\nru|")["items"];
  const auto rule = std::ranges::find(items, "ruleset", [](const Json& i) { return i["label"]; });
  EXPECT_EQ((*rule)["insertTextFormat"], 2);
}

TEST(LspSignatureHelp, TellsWhichArgumentComesNext) {
  Conversation c;
  const Json help = c.requestAt("textDocument/signatureHelp",
                                typing("require 1 < len(lerp(a, (1, 2), |", "tri   a"));
  EXPECT_EQ(help["signatures"][0]["label"], "lerp(from, to, t)");
  EXPECT_EQ(help["activeParameter"], 2);
  const Json own = c.requestAt("textDocument/signatureHelp", at("d, 1.1"));
  EXPECT_EQ(own["signatures"][0]["label"], "push(o, p, r, k)");
  EXPECT_EQ(own["activeParameter"], 2);
  EXPECT_TRUE(c.requestAt("textDocument/signatureHelp", at("elements")).is_null());
}

}  // namespace
}  // namespace af2::lsp
