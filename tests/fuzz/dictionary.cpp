// Prints the words of the language as a dictionary of libFuzzer.
#include <iostream>
#include <set>
#include <string>

#include "dsl/program/builtins.h"
#include "dsl/text/keywords.h"

int main() {
  std::set<std::string> words{"af2 1;", "->", "=>", "..", "deg", "any",  "by",   "rows",   "of",
                              "max",    "h",  "q",  "~",  "as",  "with", "only", "because"};
  for (const af2::dsl::Keyword& keyword : af2::dsl::keywords()) {
    words.emplace(keyword.word);
    words.insert(keyword.words.begin(), keyword.words.end());
  }
  for (const std::string& name : af2::dsl::builtinNames()) words.insert(name + "(");
  for (const std::string& word : words) std::cout << '"' << word << "\"\n";
}
