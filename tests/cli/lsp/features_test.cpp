// What the server knows about a place of a text.
#include <gtest/gtest.h>

#include "tests/cli/lsp/conversation.h"

namespace af2::lsp {
namespace {

const std::string kRules = R"(af2 1;

## The height of the ideal triangle.
const H = 0.866;
## Beyond the middle.
def push(o, p, r, k) = lerp(o, mid(p, r), k);

ruleset "good" {
  elements tri;
}

## Two triangles fill the corner.
rule "right 120" quality 1 {
  front a -> b -> c;
  at    c (1.5, H);
  new   d = a + (c - b);
  zone  a, b, c, push(b, c, d, 1.1), d;
  tri   a b d, b c d;
  mirror "left 120" { at c ~ 2; }
}

rule "flat {k}" for (k, height) in (5, 0.5), (10, 0.3) quality k {
  let  m = mid(a, b);
  new  c = m + (0, height);
  zone a, b, c;
  tri  a b c;
}

test "a corner" {
  front  p (0, 0) -> r (1, 0) -> s (1.5, 0.866);
  expect rule "right 120" with c = s;
}

test "flat" {
  front p (0, 0) -> r (1, 0);
  class 5;
  expect rule "flat 5";
}
)";

/// The text with a mark at the n-th occurrence of a word, `into` bytes behind its beginning.
std::string at(const std::string& word, int n = 1, std::size_t into = 0) {
  std::size_t place = kRules.find(word);
  for (int i = 1; i < n; ++i) place = kRules.find(word, place + 1);
  std::string text = kRules;
  return text.insert(place + into, "|");
}

int lineOf(const std::string& word, int n = 1) {
  const std::string before = at(word, n);
  return static_cast<int>(std::count(before.begin(), before.begin() + before.find('|'), '\n'));
}

// ---- hover --------------------------------------------------------------------------------------

std::string hoverAt(const std::string& marked, Json options = Json::object()) {
  Conversation c("{}", std::move(options));
  const Json hover = c.requestAt("textDocument/hover", marked);
  return hover.is_object() ? hover["contents"]["value"].get<std::string>() : "";
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
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

// ---- navigation ---------------------------------------------------------------------------------

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
  const Folder folder("definition");
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

// ---- rename -------------------------------------------------------------------------------------

std::string renamed(const std::string& marked, const std::string& name) {
  Conversation c;
  const Json answer = c.ask("textDocument/rename", c.paramsAt(marked, {{"newName", name}}));
  if (answer.contains("error")) return answer["error"]["message"];
  return c.edited(answer["result"]);
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
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
  EXPECT_TRUE(says(renamed(at("flat {k}"), "low"), "must hold the same"));
}

TEST(LspRename, RefusesWithWordsThatHelp) {
  EXPECT_TRUE(says(renamed(at("push(b"), "mid"), "'mid' is a function of the language"));
  EXPECT_TRUE(says(renamed(at("H);"), "front"), "'front' is a word of the language"));
  EXPECT_TRUE(says(renamed(at("H);"), "2x"), "is no name"));
  EXPECT_TRUE(says(renamed(at("H);"), "q"), "is the quality level"));
  EXPECT_TRUE(says(renamed(at("H);"), "d"), "already the name of a new vertex here (line 16)"));
  EXPECT_TRUE(says(renamed(at("d, b c d"), "c"), "already the name of a vertex here"));
  EXPECT_TRUE(says(renamed(at("d, b c d"), "a"), "an end of the base edge"));
  EXPECT_TRUE(says(renamed(at("b -> c;"), "x"), "keeps its name"));
  EXPECT_TRUE(says(renamed(at("right 120"), "left 120"), "there is already a rule \"left 120\""));
  EXPECT_TRUE(says(renamed(at("right 120"), "flat 7"), "there is already a rule \"flat {k}\""));
  EXPECT_TRUE(says(renamed(at("right 120"), ""), "a title is one line of text"));
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
  const Folder folder("rename");
  const std::string lib = folder.write("lib.af2", "af2 1;\nconst G = 0.5;\n");
  const std::string user =
      folder.write("user.af2", "af2 1;\nimport \"lib.af2\" as lib;\nconst H = lib.G;\n");
  folder.write("other.af2", "af2 1;\nconst G = 3;\n");
  Conversation c;
  c.session.client.folders = {folder.path};
  c.open("af2 1;\nconst G = 0.5;\n", lib);
  Json params = c.paramsOf(lib);
  params["position"] = {{"line", 1}, {"character", 6}};
  params["newName"] = "HALF";
  const Json changes = c.request("textDocument/rename", params)["changes"];
  EXPECT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes[user][0]["range"]["start"], Json({{"line", 2}, {"character", 14}}));
}

// ---- completion ---------------------------------------------------------------------------------

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
}

TEST(LspCompletion, OffersFilesAndTheNamesOfImports) {
  const Folder folder("completion");
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

// ---- layout and outline -------------------------------------------------------------------------

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

// ---- lenses, commands, actions ------------------------------------------------------------------

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
  const Folder folder("draw");
  const std::string path = (folder.path / "picture.svg").string();
  execute(c, "af2.draw", {{"rule", "right 120"}, {"path", path}});
  EXPECT_GT(std::filesystem::file_size(path), 1000U);
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
