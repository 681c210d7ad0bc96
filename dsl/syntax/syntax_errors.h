// Reports each syntax error once, and finds the place where the parser can continue.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "dsl/syntax/token.h"
#include "dsl/text/diagnostic.h"
#include "dsl/text/help.h"
#include "dsl/text/keywords.h"

namespace af2::dsl {

/// The kind of unit with the fault; it determines where the next one may begin.
enum class SyntaxUnit { Item, RuleHeader, Clause, Setting, TestClause, MirrorPart };

/// The kind of block that contains such a unit.
BlockKind blockOf(SyntaxUnit unit);

/// The form of the parts of a list: any expression, p -> q, p (x, y), p = x.
enum class ListPart { Expression, Walk, Position, Near, Assignment };

/// Names of parts that may be missing, other than plain symbols.
inline constexpr const char* kNoSecondFade = "no second =>";
inline constexpr const char* kExpressionWanted = "an expression";
inline constexpr const char* kItem = "an item";
inline constexpr const char* kClause = "a clause";
inline constexpr const char* kSetting = "a setting";
inline constexpr const char* kTestClause = "a test clause";
/// The rest of a unit after a fault that has been reported.
inline constexpr const char* kTold = "told already";

/// A part of the file that could not be read, with its names: it may have defined them.
struct BrokenStretch {
  Span span;
  std::vector<std::string> names;
};

class SyntaxErrors {
 public:
  SyntaxErrors(const SourceText& source, DiagnosticList& diagnostics)
      : source_(source), diagnostics_(diagnostics) {}

  /// Reports that `wanted` is missing at `where`, in a unit that begins at `first`. Returns the
  /// place after `first` where the parser can continue.
  const Token* tellAndRecover(SyntaxUnit unit, const Token* first, const Token* where,
                              const Token* last, const std::string& wanted);

  /// The same in a part of a list that begins at `part`, in a unit whose word is `head`. Returns
  /// the ',' before the next part. If no other part can be found, reports nothing and returns
  /// null.
  const Token* tellPart(SyntaxUnit unit, const Token* head, const Token* part, const Token* where,
                        ListPart next, const std::string& wanted);
  /// Whether a list seems to end here.
  static bool mayEndList(SyntaxUnit unit, const Token* token);

  void tell(Code code, Span span, std::string message, const Help& help,
            std::vector<DiagnosticNote> notes = {});
  /// Whether a unit that is complete except for its ';' ends before `where`, because another unit
  /// or the end of its block follows. Reports the missing ';'.
  bool tellMissingEnd(SyntaxUnit unit, const Token* where);
  /// Reports that the `{` of a block is missing before `clause`; the parser continues as if it were
  /// there.
  void tellMissingBrace(const Token* clause);
  /// Notes that `af2 1;` is at the wrong place, which has been reported.
  void expectVersionAt(const Token* token) { version_ = token; }
  /// Notes a part that is skipped without being read.
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
  const Token* toldWord_ = nullptr;      ///< a word already reported with another fault
  const Token* shortChainOf_ = nullptr;  ///< the clause of which a chain was too short
  int missingBraces_ = 0;  ///< blocks that were assumed to end early; their `}` may still follow
};

}  // namespace af2::dsl
