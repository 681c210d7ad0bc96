// Prints clauses and headers in their canonical form, without comments and layout.
#pragma once

#include <string>

#include "dsl/syntax/ast.h"

namespace af2::dsl {

/// A clause: its keyword and the rest.
struct Line {
  std::string word, rest;
};

Line lineOf(const Clause& clause);
Line lineOf(const Setting& setting);
Line lineOf(const TestClause& clause);

/// rule "title" for (k) in (1), (2) quality k
std::string ruleHeader(const Rule& rule);

/// A string in quotes, with escapes.
std::string quoted(const std::string& text);

inline std::string nameOf(const Name& name) { return name.text; }

template <class List, class Print>
std::string join(const List& list, Print print, const char* separator = ", ") {
  std::string text;
  bool isFirst = true;
  for (const auto& part : list) {
    if (!isFirst) text += separator;
    isFirst = false;
    text += print(part);
  }
  return text;
}

}  // namespace af2::dsl
