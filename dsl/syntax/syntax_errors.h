// Telling what could not be read, once, and finding where reading can go on.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "dsl/syntax/token.h"
#include "dsl/text/diagnostic.h"
#include "dsl/text/help.h"
#include "dsl/text/keywords.h"

namespace af2::dsl {

/// What was being read when it broke; says where the next one may begin.
enum class SyntaxUnit { Item, RuleHeader, Clause, Setting, TestClause, MirrorPart };

/// The block whose clauses such a unit is one of.
BlockKind blockOf(SyntaxUnit unit);

/// What the parts of a list look like: any expression, p -> q, p (x, y), p = x.
enum class ListPart { Expression, Walk, Position, Assignment };

/// Parts that the grammar may find missing, beyond plain symbols.
inline constexpr const char* kNoSecondFade = "no second =>";
inline constexpr const char* kExpressionWanted = "an expression";
inline constexpr const char* kItem = "an item";
inline constexpr const char* kClause = "a clause";
inline constexpr const char* kSetting = "a setting";
inline constexpr const char* kTestClause = "a test clause";
/// The rest of a unit of which a part has been told to be wrong.
inline constexpr const char* kTold = "told already";

/// A stretch of the file that could not be read, with the names that occur in it: they may have
/// been meant to be defined there.
struct BrokenStretch {
  Span span;
  std::vector<std::string> names;
};

class SyntaxErrors {
 public:
  SyntaxErrors(const SourceText& source, DiagnosticList& diagnostics)
      : source_(source), diagnostics_(diagnostics) {}

  /// Tells that `wanted` was not found at `where`, in a unit that began at `first`. Returns where
  /// to go on, beyond `first`.
  const Token* tellAndRecover(SyntaxUnit unit, const Token* first, const Token* where,
                              const Token* last, const std::string& wanted);

  /// The same in a part of a list that begins at `part`, in a unit whose word is `head`. Returns
  /// the
  /// ',' before the next part, or null, without telling, if no other part can be found.
  const Token* tellPart(SyntaxUnit unit, const Token* head, const Token* part, const Token* where,
                        ListPart next, const std::string& wanted);
  /// Whether a list may end here, for all that can be seen.
  static bool mayEndList(SyntaxUnit unit, const Token* token);

  void tell(Code code, Span span, std::string message, const Help& help,
            std::vector<DiagnosticNote> notes = {});
  /// Whether a unit of which all but the ';' has been read may end before `where`, because another
  /// one or the end of its block is there; that the ';' is missing is told.
  bool tellMissingEnd(SyntaxUnit unit, const Token* where);
  /// Tells that a block's `{` is missing before `clause`; reading goes on as if it stood there.
  void tellMissingBrace(const Token* clause);
  /// `af2 1;` stands where it does not belong; that has been told.
  void expectVersionAt(const Token* token) { version_ = token; }
  /// What is left out without being read.
  void leaveOut(const Token* first, const Token* last);
  std::vector<BrokenStretch> takeBroken() { return std::move(broken_); }

  /// Whether an item of the file begins here, as `rule "...` and `const H` do.
  static bool beginsItem(const Token* token);

 private:
  void tellMissing(SyntaxUnit unit, const Token* first, const Token* where,
                   const std::string& wanted);
  void tellUnknownWord(const Token* where, const std::string& wanted);
  void tellUnclosed(SyntaxUnit unit, const Token* first, const Token* where);

  const SourceText& source_;
  DiagnosticList& diagnostics_;
  std::vector<BrokenStretch> broken_;
  std::set<std::string> wordsToldAsNames_;
  const Token* resumedAt_ = nullptr;
  const Token* version_ = nullptr;
  const Token* toldWord_ = nullptr;      ///< told with something else
  const Token* shortChainOf_ = nullptr;  ///< the clause of which a chain was too short
  int missingBraces_ = 0;  ///< blocks that were taken to end early: their `}` may still come
};

}  // namespace af2::dsl
