// The context of a place in a rule file, determined from words alone.
#pragma once

#include <string>
#include <vector>

#include "dsl/symbols/symbol_index.h"
#include "dsl/syntax/token.h"
#include "dsl/text/keywords.h"

namespace af2::dsl {

/// A name that a block defines above the place.
struct LocalName {
  std::string name;
  SymbolKind kind = SymbolKind::Vertex;
};

/// A call whose parentheses are open at the place.
struct OpenCall {
  std::string qualifier, name;
  std::size_t argument = 0;  ///< the index of the argument at the place, from 0
};

struct BlockContext {
  BlockKind block = BlockKind::File;
  bool isInComment = false;
  bool isInString = false;
  Span word;  ///< the part of the word, or of the contents of the string, before the place
  std::vector<Token> statement;  ///< the words of the clause or item before `word`
  std::string title;  ///< of the rule, test, ... around the place; for a property, of its rule
  std::vector<LocalName> names;
  std::vector<OpenCall> calls;  ///< from the outermost to the innermost

  bool isAtBeginning() const { return statement.empty(); }
  /// Whether the clause begins with this word.
  bool begins(const char* first) const { return !statement.empty() && statement[0].is(first); }
  /// Whether the last word before the place is this one.
  bool follows(const char* last) const { return !statement.empty() && statement.back().is(last); }
};

BlockContext contextAt(const SourceText& source, std::uint32_t offset);

}  // namespace af2::dsl
