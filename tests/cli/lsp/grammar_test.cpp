// The words that editors colour are those of the language.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>

#include "dsl/program/builtins.h"
#include "dsl/symbols/word_help.h"
#include "dsl/text/words.h"

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
  for (const auto table :
       {dsl::itemWords(), dsl::clauseWords(), dsl::settingWords(), dsl::testWords()})
    for (const std::string_view word : table)
      EXPECT_TRUE(coloured.contains(std::string(word))) << word;
  for (const std::string_view word : dsl::reservedWords())
    EXPECT_TRUE(coloured.contains(std::string(word))) << word;
}

TEST(TextMateGrammar, ColoursNoClauseThatTheLanguageDoesNotHave) {
  std::set<std::string> known;
  for (const auto table : {dsl::itemWords(), dsl::clauseWords(), dsl::settingWords(),
                           dsl::testWords(), dsl::reservedWords()})
    for (const std::string_view word : table) known.insert(std::string(word));
  for (const char* scope : {"keyword.control.clause", "keyword.declaration"})
    for (const std::string& word : wordsIn(scope)) EXPECT_TRUE(known.contains(word)) << word;
}

TEST(TextMateGrammar, ColoursTheFunctionsOfTheLanguage) {
  const std::set<std::string> coloured = wordsIn("support.function");
  std::set<std::string> known;
  for (const std::string& name : dsl::builtinNames()) known.insert(name);
  EXPECT_EQ(coloured, known);
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
  for (const auto table :
       {dsl::itemWords(), dsl::clauseWords(), dsl::settingWords(), dsl::testWords()})
    for (const std::string_view word : table) EXPECT_TRUE(dsl::helpForKeyword(word)) << word;
  for (const dsl::Builtin& b : dsl::builtins()) {
    ASSERT_TRUE(dsl::helpForBuiltin(b.name)) << b.name;
    EXPECT_EQ(dsl::helpForBuiltin(b.name)->usage, b.usage);
  }
  for (const dsl::BuiltinMetric& m : dsl::builtinMetrics()) {
    ASSERT_TRUE(dsl::helpForBuiltin(m.name)) << m.name;
    EXPECT_EQ(dsl::helpForBuiltin(m.name)->usage, m.usage);
  }
  for (const std::string& name : dsl::builtinNames())
    EXPECT_TRUE(dsl::helpForBuiltin(name)) << name;
}

}  // namespace
}  // namespace af2
