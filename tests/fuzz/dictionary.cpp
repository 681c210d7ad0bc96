// Prints the words of the language as a dictionary of libFuzzer.
#include <iostream>
#include <set>
#include <string>

#include "dsl/program/builtins.h"
#include "dsl/text/words.h"

int main() {
  std::set<std::string> words{"af2 1;", "->", "=>", "..", "deg", "any",  "by",   "rows",   "of",
                              "max",    "h",  "q",  "~",  "as",  "with", "only", "because"};
  for (const auto list : {af2::dsl::itemWords(), af2::dsl::clauseWords(), af2::dsl::settingWords(),
                          af2::dsl::testWords()})
    words.insert(list.begin(), list.end());
  for (const std::string& name : af2::dsl::builtinNames()) words.insert(name + "(");
  for (const std::string& word : words) std::cout << '"' << word << "\"\n";
}
