#include "dsl/symbols/word_help.h"

#include <algorithm>

#include "dsl/program/builtins.h"

namespace af2::dsl {
namespace {

WordHelp levelHelp() {
  return {"q", "q", "The quality level of the base edge: 1, and one more after each refusal."};
}

}  // namespace

std::vector<WordHelp> builtinHelp() {
  std::vector<WordHelp> all;
  for (const std::string_view name : builtinNames())
    all.push_back({std::string(name), usageOf(name), helpOf(name)});
  all.push_back(levelHelp());
  return all;
}

const Keyword* helpForKeyword(BlockKind block, std::string_view word) {
  if (const Keyword* here = findKeyword(block, word)) return here;
  const auto found = std::ranges::find(keywords(), word, &Keyword::word);
  return found == keywords().end() ? nullptr : &*found;
}

std::optional<WordHelp> helpForBuiltin(std::string_view word) {
  if (word == "q") return levelHelp();
  if (!isBuiltin(word)) return std::nullopt;
  return WordHelp{std::string(word), usageOf(word), helpOf(word)};
}

}  // namespace af2::dsl
