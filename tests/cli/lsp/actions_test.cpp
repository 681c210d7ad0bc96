// Lenses, commands, quick fixes and hints.
#include <gtest/gtest.h>

#include "tests/cli/lsp/conversation.h"
#include "tests/cli/lsp/sample_rules.h"

namespace af2::lsp {
namespace {

TEST(LspLens, DrawsAndTests) {
  Conversation c;
  c.open(kRules);
  std::vector<std::string> lenses;
  for (const Json& lens : c.request("textDocument/codeLens", c.paramsOf()))
    lenses.push_back(std::to_string(lens["range"]["start"]["line"].get<int>()) + " " +
                     lens["command"]["title"].get<std::string>());
  const auto line = [](const char* word) { return std::to_string(lineOf(word)) + " "; };
  for (const std::string& lens :
       {line("ruleset") + "draw all", line("ruleset") + "test all (2)",
        line("rule \"right") + "draw", line("rule \"right") + "test (1)", line("mirror") + "draw",
        line("rule \"flat") + "test (1)", line("test \"a") + "test"})
    EXPECT_TRUE(holds(lenses, lens)) << lens;
}

Json execute(Conversation& c, const char* command, Json argument) {
  argument["uri"] = Conversation::kUri;
  return c.request("workspace/executeCommand",
                   {{"command", command}, {"arguments", Json::array({argument})}});
}

TEST(LspCommands, DrawReturnsAPicture) {
  Conversation c("{}", {{"returnPictures", true}});
  c.open(kRules);
  for (const char* rule : {"right 120", "left 120", "flat {k}", "flat 10"})
    EXPECT_TRUE(says(execute(c, "af2.draw", {{"rule", rule}})["svg"], "<svg")) << rule;
  EXPECT_TRUE(says(execute(c, "af2.draw", Json::object())["svg"], "<svg"));
  const Folder folder;
  const std::string path = (folder.path() / "picture.svg").string();
  execute(c, "af2.draw", {{"rule", "right 120"}, {"path", path}});
  EXPECT_GT(std::filesystem::file_size(path), 1000U);
  // No name means standard output, to which the answers go.
  EXPECT_EQ(execute(c, "af2.draw", {{"rule", "right 120"}, {"path", "-"}})["path"], "-");
  EXPECT_TRUE(std::filesystem::remove("-"));
  Json params{{"command", "af2.draw"},
              {"arguments", {{{"uri", Conversation::kUri}, {"rule", "none"}}}}};
  EXPECT_TRUE(says(c.fault("workspace/executeCommand", params), "\"none\" cannot be drawn"));
  EXPECT_TRUE(says(c.fault("workspace/executeCommand", {{"command", "rm"}}), "no command 'rm'"));
}

TEST(LspCommands, TestTellsWhatFailed) {
  Conversation c;
  c.open(kRules);
  EXPECT_EQ(execute(c, "af2.test", Json::object())["passed"], 2);
  EXPECT_EQ(execute(c, "af2.test", {{"titles", {"flat"}}})["passed"], 1);
  c.open(replaced(kRules, "expect rule \"flat 5\"", "expect stuck"));
  const Json result = execute(c, "af2.test", Json::object());
  EXPECT_EQ(result["failed"], 1);
  const Json found = c.diagnostics();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0]["source"], "af2 test");
  EXPECT_EQ(found[0]["range"]["start"]["line"], lineOf("expect rule \"flat"));
}

std::string fixed(const std::string& text, const std::string& title) {
  Conversation c;
  c.open(text);
  c.diagnostics();
  c.checks.run();
  Json params = c.paramsOf();
  const Json diagnostics = c.diagnostics();
  if (diagnostics.empty()) return "nothing is wrong";
  params["range"] = diagnostics[0]["range"];
  params["context"] = {{"diagnostics", diagnostics}};
  std::string titles;
  for (const Json& action : c.request("textDocument/codeAction", params)) {
    if (action["title"] == title) return c.edited(action["edit"]);
    titles += action["title"].get<std::string>() + "; ";
  }
  return titles;
}

TEST(LspActions, DoWhatDiagnosticsPropose) {
  EXPECT_EQ(fixed(replaced(kRules, "lerp(o", "lerb(o"), "'lerb' becomes 'lerp'"), kRules);
  EXPECT_EQ(fixed(replaced(kRules, "\"flat 5\"", "\"flad 5\""), "'flad 5' becomes 'flat 5'"),
            kRules);
  EXPECT_EQ(fixed(replaced(kRules, "elements tri", "element tri"), "'element' becomes 'elements'"),
            kRules);
  EXPECT_EQ(fixed(replaced(kRules, "(1.5, H);", "(1.5, H)"), "';' added"), kRules);
  EXPECT_EQ(fixed(kRules.substr(8), "'af2 1;' added"), kRules);
  EXPECT_EQ(fixed(replaced(kRules, "elements tri;", "elements tri;;"), "';' deleted"), kRules);
  EXPECT_TRUE(says(fixed(replaced(kRules, "  mirror \"left 120\" { at c ~ 2; }\n", ""),
                         "the mirror image \"left 120\" added"),
                   "\n  mirror \"left 120\";\n}"));
}

TEST(LspActions, TurnCounterExamplesIntoTests) {
  const std::string text = replaced(kRules, "zone a, b, c;", "zone a, b, m + (0, 0.1);");
  const std::string more = fixed(text, "add the counter-example as a test");
  ASSERT_TRUE(more.starts_with(text)) << more;
  Conversation c;
  c.open(more);
  for (const Json& d : c.diagnostics()) EXPECT_NE(d["severity"], 1) << d;
}

TEST(LspActions, TurnMissingMirrorImagesIntoTests) {
  const std::string text = replaced(kRules, "  mirror \"left 120\" { at c ~ 2; }\n", "");
  const std::string more = fixed(text, "add the counter-example as a test");
  EXPECT_TRUE(says(more, "right 120: its mirror image is done alike"));
  Conversation c;
  c.open(text);
  c.diagnostics();
  c.checks.run();
  int told = 0;
  for (const Json& d : c.diagnostics()) told += d["code"] == "AF2-M1";
  EXPECT_EQ(told, 1) << "by the text and by the checks";
}

TEST(LspActions, DoNotAskForMirrorImagesThatWouldNeverBeChosen) {
  Conversation c;
  c.open(
      "af2 1;\nruleset \"s\" { elements tri; match 0.5; }\n"
      "rule \"right\" quality 1 {\n  front a -> b -> c;\n  at c (0.5, 0.866) ~ 3;\n"
      "  zone a, b, c;\n  tri a b c;\n}\n"
      "rule \"left\" quality 1 {\n  front d -> a -> b;\n  at d (0.52, 0.866) ~ 2;\n"
      "  zone a, b, d;\n  tri a b d;\n  cost -1;\n  meta { allow \"M1\"; }\n}\n");
  const auto count = [&] {
    int told = 0;
    for (const Json& d : c.diagnostics()) told += d["code"] == "AF2-M1";
    return told;
  };
  EXPECT_EQ(count(), 1) << "as far as the text tells";
  c.checks.run();
  EXPECT_EQ(count(), 0);
}

TEST(LspInlayHints, ShowTheNewFront) {
  Conversation c;
  c.open(kRules);
  Json params = c.paramsOf();
  params["range"] = {{"start", {{"line", 0}, {"character", 0}}},
                     {"end", {{"line", 99}, {"character", 0}}}};
  const Json hints = c.request("textDocument/inlayHint", params);
  ASSERT_EQ(hints.size(), 2U);
  EXPECT_EQ(hints[0]["label"], "new front: a -> d -> c");
  EXPECT_EQ(hints[0]["position"]["line"], lineOf("tri   a b d"));
}

/// Whatever is asked about whatever place, there is an answer.
TEST(LspServer, AnswersAtEveryPlaceOfAnyText) {
  std::string broken = kRules;
  for (std::size_t i = 7; i < broken.size(); i += 97) broken[i] = "{}\"(;~"[i % 6];
  for (const std::string& text : {kRules.substr(0, 700), broken}) {
    Conversation c;
    c.open(text);
    const TextMap map = c.session.map(text);
    for (std::uint32_t offset = 0; offset <= text.size(); offset += 5)
      for (const char* method :
           {"textDocument/hover", "textDocument/completion", "textDocument/definition",
            "textDocument/references", "textDocument/signatureHelp"}) {
        Json params = c.paramsOf();
        params["position"] = map.position(offset);
        EXPECT_TRUE(c.ask(method, params).contains("result")) << method << " at " << offset;
      }
  }
}

}  // namespace
}  // namespace af2::lsp
