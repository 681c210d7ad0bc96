// Sound rule files with words changed at random: whatever comes out is told or works, and is
// formatted to a text that stays as it is.
#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>

#include "dsl/format/printer.h"
#include "dsl/load/rule_file.h"
#include "dsl/run/rule_tests.h"
#include "dsl/syntax/lexer.h"

namespace af2::dsl {
namespace {

using Words = std::vector<std::string>;

Words wordsOf(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  DiagnosticList list;
  const SourceText source("x.af2", text.str());
  Words words;
  for (const Token& token : readTokens(source, list).tokens)
    words.emplace_back(source.text().substr(token.span.begin, token.span.end - token.span.begin));
  return words;
}

void mutate(Words& words, const Words& others, std::mt19937& random) {
  const std::size_t at = random() % words.size();
  switch (random() % 5) {
    case 0:
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(at));
      break;
    case 1:
      words[at] = others[random() % others.size()];
      break;
    case 2:
      words.insert(words.begin() + static_cast<std::ptrdiff_t>(at),
                   others[random() % others.size()]);
      break;
    case 3:
      std::swap(words[at], words[random() % words.size()]);
      break;
    default:
      if (!words[at].empty())
        words[at][random() % words[at].size()] = static_cast<char>(random() % 256);
  }
}

std::string joined(const Words& words) {
  std::string text;
  for (const std::string& word : words)
    text += word + (word == ";" || word == "{" || word == "}" ? "\n" : " ");
  return text;
}

TEST(Mutations, NeverBreakTheReader) {
  const std::vector<Words> files{wordsOf(AF2_SOURCE_DIR "/rules/tri/classic.af2"),
                                 wordsOf(AF2_SOURCE_DIR "/tests/dsl/cases"
                                                        "/sound.af2"),
                                 wordsOf(AF2_SOURCE_DIR "/tests/dsl/cases"
                                                        "/zones.af2")};
  constexpr unsigned kSeed = 11;
  std::mt19937 random(kSeed);
  for (int i = 0; i < 400; ++i) {
    Words words = files[random() % files.size()];
    const Words& others = files[random() % files.size()];
    for (unsigned k = 1 + random() % 4; k > 0 && words.size() > 1; --k)
      mutate(words, others, random);
    const std::string text = joined(words);
    const LoadedRules loaded = loadRulesFromText(AF2_SOURCE_DIR
                                                 "/tests/dsl/cases"
                                                 "/mutated.af2",
                                                 text);
    EXPECT_EQ(loaded.rules == nullptr, hasErrors(loaded.diagnostics)) << text;
    if (loaded.rules) runRuleTests(loaded);
    const std::string once = format("x.af2", text).text;
    if (!once.empty()) {
      EXPECT_EQ(format("x.af2", once).text, once) << text;
    }
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace af2::dsl
