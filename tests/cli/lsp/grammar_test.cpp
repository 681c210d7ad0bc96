// The words that editors colour are those of the language.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "dsl/program/builtins.h"
#include "dsl/symbols/word_help.h"
#include "dsl/text/keywords.h"

namespace af2 {
namespace {

using Json = nlohmann::json;

Json read(const std::string& name) {
  std::ifstream file(AF2_SOURCE_DIR "/examples/vscode-af2/" + name);
  return Json::parse(file);
}

void collect(const Json& json, const std::string& scope, std::set<std::string>& words) {
  if (json.is_array()) {
    for (const Json& item : json) collect(item, scope, words);
  } else if (json.is_object()) {
    std::string names = json.value("name", std::string());
    if (json.contains("captures") && json["captures"].contains("1"))
      names += json["captures"]["1"].value("name", std::string());
    if (names.find(scope) != std::string::npos && json.contains("match")) {
      const auto pattern = json["match"].get<std::string>();
      const std::regex word("[A-Za-z_][A-Za-z_0-9]*");
      // \b, \w and \s are not words.
      const std::string plain =
          std::regex_replace(pattern, std::regex(R"(\\[a-z]|\[[^\]]*\])"), " ");
      for (std::sregex_iterator i(plain.begin(), plain.end(), word), end; i != end; ++i)
        words.insert(i->str());
    }
    for (const auto& [key, value] : json.items()) collect(value, scope, words);
  }
}

std::set<std::string> wordsIn(const std::string& scope) {
  std::set<std::string> words;
  collect(read("syntaxes/af2.tmLanguage.json")["repository"], scope, words);
  return words;
}

TEST(TextMateGrammar, ColoursAllKeywordsOfTheLanguage) {
  const std::set<std::string> coloured = wordsIn("keyword.");
  for (const dsl::Keyword& keyword : dsl::keywords())
    EXPECT_TRUE(coloured.contains(std::string(keyword.word))) << keyword.word;
  for (const std::string_view word : dsl::reservedWords())
    EXPECT_TRUE(coloured.contains(std::string(word))) << word;
}

TEST(TextMateGrammar, ColoursNoClauseThatTheLanguageDoesNotHave) {
  std::set<std::string> known;
  for (const dsl::Keyword& keyword : dsl::keywords()) known.emplace(keyword.word);
  for (const char* scope : {"keyword.control.clause", "keyword.declaration"})
    for (const std::string& word : wordsIn(scope)) EXPECT_TRUE(known.contains(word)) << word;
}

// ---- what follows from the tables ---------------------------------------------------------------

std::string textOf(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Compares a file with what it should be; AF2_UPDATE_GRAMMAR=1 in the environment writes it.
void expectFile(const std::string& name, const std::string& wanted) {
  const std::string path = AF2_SOURCE_DIR "/" + name;
  if (std::getenv("AF2_UPDATE_GRAMMAR")) std::ofstream(path) << wanted;
  EXPECT_TRUE(textOf(path) == wanted)
      << name << " does not follow from the tables of the language; to write it anew, run\n"
      << "  AF2_UPDATE_GRAMMAR=1 build/tests/cli_test --gtest_filter='*FollowsFromTheTable*'";
}

/// a|b|c, of which each is there once.
template <class Words>
std::string anyOf(const Words& words) {
  std::string list;
  std::set<std::string> seen;
  for (const auto& word : words)
    if (seen.emplace(word).second) list += (list.empty() ? "" : "|") + std::string(word);
  return list;
}

TEST(TextMateGrammar, FollowsFromTheTable) {
  const std::string name = "examples/vscode-af2/syntaxes/af2.tmLanguage.json";
  std::vector<std::string_view> reserved, others, functions, metrics;
  for (const dsl::Keyword& keyword : dsl::keywords())
    if (keyword.block != dsl::BlockKind::File)
      (keyword.isReserved ? reserved : others).push_back(keyword.word);
  const std::vector<std::string> builtins = dsl::builtinNames();
  for (const std::string& builtin : builtins)
    (dsl::findBuiltinMetric(builtin) ? metrics : functions).push_back(builtin);

  auto grammar = nlohmann::ordered_json::parse(textOf(AF2_SOURCE_DIR "/" + name));
  auto& clauses = grammar["repository"]["clauses"]["patterns"];
  auto& calls = grammar["repository"]["calls"]["patterns"];
  clauses[0]["match"] = R"(\b()" + anyOf(reserved) + R"()\b)";
  // Words that may be names begin a clause at the start of a line, of a block or behind a `;`.
  clauses[1]["match"] = R"((?:^|(?<=[;{]))\s*()" + anyOf(others) + R"()\b(?!\s*\())";
  calls[0]["match"] = R"(\b()" + anyOf(functions) + R"()\b(?=\s*\())";
  calls[1]["match"] = R"(\b()" + anyOf(metrics) + R"()\b)";
  expectFile(name, grammar.dump(2) + "\n");
}

/// One production in EBNF: alternatives fill lines of a hundred characters.
std::string production(const std::string& name, const std::vector<std::string_view>& alternatives) {
  constexpr std::size_t kWidth = 100, kIndent = 11;
  std::string text, line = name + std::string(kIndent - name.size(), ' ') + "= ";
  for (const std::string_view alternative : alternatives) {
    const bool isFirst = alternative.data() == alternatives.front().data();
    if (!isFirst && line.size() + alternative.size() + 3 > kWidth) {
      text += line + "\n";
      line = std::string(kIndent, ' ') + "| ";
    } else if (!isFirst) {
      line += " | ";
    }
    line += alternative;
  }
  text += line + " ;\n";
  const std::size_t lineBreak = text.find('\n');
  if (alternatives.size() == 1 && lineBreak + 1 < text.size())
    text.insert(lineBreak + 1, kIndent + 2, ' ');
  return text;
}

/// Puts a production in the place of the one with its name.
void replaceProduction(std::string& text, const std::string& name,
                       const std::vector<std::string_view>& alternatives) {
  const std::string head = "\n" + name + std::string(11 - name.size(), ' ') + "= ";
  const std::size_t begin = text.find(head, text.find("```ebnf"));
  ASSERT_NE(begin, text.npos) << "docs/language.md has no production " << name;
  const std::size_t end = text.find(" ;\n", begin) + 3;
  text.replace(begin + 1, end - begin - 1, production(name, alternatives));
}

TEST(DocumentedGrammar, FollowsFromTheTable) {
  std::string text = textOf(AF2_SOURCE_DIR "/docs/language.md");
  const auto rowsOf = [](dsl::BlockKind block) {
    std::vector<std::string_view> rows;
    for (const dsl::Keyword& keyword : dsl::keywords())
      if (keyword.block == block && !keyword.grammar.empty()) rows.push_back(keyword.grammar);
    return rows;
  };
  for (const dsl::Keyword& keyword : dsl::keywords()) {
    if (keyword.block == dsl::BlockKind::File)
      replaceProduction(text, std::string(keyword.word), {keyword.grammar});
    EXPECT_NE(text.find("\"" + std::string(keyword.word) + "\"", text.find("```ebnf")), text.npos)
        << "the grammar in docs/language.md does not have the word " << keyword.word;
  }
  replaceProduction(text, "clause", rowsOf(dsl::BlockKind::Rule));
  replaceProduction(text, "setting", rowsOf(dsl::BlockKind::RuleSet));
  replaceProduction(text, "testclause", rowsOf(dsl::BlockKind::Test));
  expectFile("docs/language.md", text);
}

TEST(LanguageConfiguration, HasCommentsAndBrackets) {
  const Json configuration = read("language-configuration.json");
  EXPECT_EQ(configuration["comments"]["lineComment"], "#");
  EXPECT_EQ(configuration["brackets"].size(), 2U);
  // A doc comment goes on on the next line.
  const std::regex rule(configuration["onEnterRules"][0]["beforeText"].get<std::string>());
  EXPECT_TRUE(std::regex_match("## text", rule));
  EXPECT_FALSE(std::regex_match("# text", rule));
}

TEST(WordHelp, ThereIsOneForEveryWord) {
  for (const dsl::Keyword& keyword : dsl::keywords()) EXPECT_FALSE(keyword.help.empty());
  for (const std::string& name : dsl::builtinNames()) {
    ASSERT_TRUE(dsl::helpForBuiltin(name)) << name;
    EXPECT_FALSE(dsl::helpForBuiltin(name)->meaning.empty()) << name;
    EXPECT_EQ(dsl::helpForBuiltin(name)->usage, dsl::usageOf(name));
  }
}

TEST(WordHelp, AWordIsExplainedAsItIsUsedInTheBlock) {
  const auto help = [](dsl::BlockKind block) { return dsl::helpForKeyword(block, "front")->help; };
  EXPECT_NE(help(dsl::BlockKind::Rule), help(dsl::BlockKind::Test));
  EXPECT_NE(help(dsl::BlockKind::Rule), help(dsl::BlockKind::RuleSet));
}

}  // namespace
}  // namespace af2
