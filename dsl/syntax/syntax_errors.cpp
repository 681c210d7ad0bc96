#include "dsl/syntax/syntax_errors.h"

#include <algorithm>

namespace af2::dsl {

BlockKind blockOf(SyntaxUnit unit) {
  switch (unit) {
    case SyntaxUnit::Item:
      return BlockKind::File;
    case SyntaxUnit::RuleHeader:
    case SyntaxUnit::Clause:
      return BlockKind::Rule;
    case SyntaxUnit::Setting:
      return BlockKind::RuleSet;
    case SyntaxUnit::TestClause:
      return BlockKind::Test;
    case SyntaxUnit::MirrorPart:
      return BlockKind::Mirror;
  }
  return BlockKind::File;
}

namespace {

bool isOneOf(const Token& token, std::span<const std::string_view> words) {
  return token.kind == TokenKind::Name &&
         std::find(words.begin(), words.end(), token.text) != words.end();
}

/// The words at which the parser may continue after a broken unit. After a fault in the braces of a
/// mirror, a clause of the rule may follow.
std::span<const std::string_view> wordsOf(SyntaxUnit unit) {
  return keywordsOf(unit == SyntaxUnit::MirrorPart ? BlockKind::Rule : blockOf(unit));
}

/// Where the parser may continue in a rule, test or other block whose beginning is known. Tests
/// contain `rule "..."`, as items do, so there it counts only at the beginning of a line.
bool endsBlockEarly(const Token* token, SyntaxUnit unit) {
  if (token->kind == TokenKind::End) return true;
  return SyntaxErrors::beginsItem(token) && (unit != SyntaxUnit::TestClause || token->startsLine);
}

const Token* skipUnit(SyntaxUnit unit, const Token* first, const Token* from) {
  int braces = 0;
  if (unit != SyntaxUnit::RuleHeader)
    for (const Token* t = first; t < from; ++t) braces += t->is("{") ? 1 : t->is("}") ? -1 : 0;
  for (const Token* t = from;; ++t) {
    if (endsBlockEarly(t, unit) && t > first) return t;
    if (t->kind == TokenKind::End) return t;
    if (t->is("{")) {
      if (unit == SyntaxUnit::RuleHeader) return t;
      ++braces;
    } else if (t->is("}")) {
      if (braces == 0) return unit == SyntaxUnit::Item ? t + 1 : t;
      const bool isLast = t[1].startsLine || t[1].is("}") || isOneOf(t[1], wordsOf(unit)) ||
                          unit == SyntaxUnit::Item || unit == SyntaxUnit::RuleHeader;
      if (--braces <= 0 && isLast) return t + 1;
      braces = std::max(braces, 0);
    } else if (t->is(";") && braces == 0) {
      // A header that ends with `;` has no body: an intended body cannot be distinguished from
      // clauses.
      return t + 1;
    } else if (braces == 0 && t > first && t->startsLine && isOneOf(*t, wordsOf(unit)) &&
               unit != SyntaxUnit::Item && unit != SyntaxUnit::RuleHeader) {
      return t;
    }
  }
}

}  // namespace

bool SyntaxErrors::beginsItem(const Token* token) {
  if (!isOneOf(*token, keywordsOf(BlockKind::File))) return false;
  const Token& next = token[1];  // safe: the list ends with End, which begins no item
  if (token->is("import") || token->is("rule") || token->is("ruleset") || token->is("test") ||
      token->is("property"))
    return next.kind == TokenKind::String;
  return next.kind == TokenKind::Name && !next.is("in");
}

void SyntaxErrors::tell(Code code, Span span, std::string message, const Help& help,
                        std::vector<DiagnosticNote> notes) {
  if (!diagnostics_.takes(Severity::Error)) return;
  Diagnostic d(code);
  d.message = std::move(message);
  d.place = placeOf(source_, span);
  d.notes = std::move(notes);
  setHelp(d, source_, span, help);
  diagnostics_.add(std::move(d));
}

bool SyntaxErrors::mayEndList(SyntaxUnit unit, const Token* token) {
  for (const char* symbol : {",", ";", ")", "}", "when"})
    if (token->is(symbol)) return true;
  return token->kind == TokenKind::End || beginsItem(token) || isOneOf(*token, wordsOf(unit));
}

namespace {

/// The ',' that separates the next part of a list after `where`, outside of brackets in the part.
const Token* nextComma(SyntaxUnit unit, const Token* part, const Token* where) {
  int depth = 0;
  for (const Token* t = part;; ++t) {
    const bool isEnd = t->kind == TokenKind::End || t->is(";") || t->is("{") || t->is("}") ||
                       SyntaxErrors::beginsItem(t) ||
                       (t > part && t->startsLine && isOneOf(*t, wordsOf(unit)));
    if (isEnd) return nullptr;
    depth += t->is("(") - t->is(")");
    if (depth < 0) return nullptr;
    if (depth == 0 && t >= where && t->is(",")) return t;
  }
}

bool begins(ListPart part, const Token* token) {
  if (part == ListPart::Expression) return true;
  if (token->kind != TokenKind::Name) return false;
  if (part == ListPart::Walk) return true;
  return token[1].is(part == ListPart::Position ? "(" : part == ListPart::Near ? "of" : "=");
}

}  // namespace

const Token* SyntaxErrors::tellPart(SyntaxUnit unit, const Token* head, const Token* part,
                                    const Token* where, ListPart next, const std::string& wanted) {
  const Token* comma = nextComma(unit, part, where);
  if (!comma || !begins(next, comma + 1)) return nullptr;
  const bool isTold = where->isDoubtful || (where - 1)->isDoubtful;
  if (!isTold) tellMissing(unit, head, where, wanted);
  return comma;
}

const Token* SyntaxErrors::tellAndRecover(SyntaxUnit unit, const Token* first, const Token* where,
                                          const Token* last, const std::string& wanted) {
  const bool isTold =
      wanted == kTold || where->isDoubtful || (where > first && (where - 1)->isDoubtful);
  const bool isItemPart =
      wanted == kItem || wanted == kClause || wanted == kSetting || wanted == kTestClause;
  // Directly after a resume, a fault may follow from the previous one. A missing brace after a
  // complete clause does not.
  const bool isFresh = where != resumedAt_ || where == first ||
                       (wanted == "}" && where > first && (where - 1)->is(";"));
  if (!isTold && isFresh) {
    if (isItemPart)
      tellUnknownWord(where, wanted);
    else
      tellMissing(unit, first, where, wanted);
  }
  if (wanted == "}") ++missingBraces_;
  const bool nextBegins = wanted == ";" && where > first && isOneOf(*where, wordsOf(unit));
  const Token* resumed =
      nextBegins ? where : skipUnit(unit, first, where == first ? first + 1 : where);
  if (where == first && !endsBlockEarly(first, unit)) {
    // The first word itself is wrong, so its whole unit is skipped.
    resumed = skipUnit(unit, first, first->is("{") || first->is(";") ? first : first + 1);
  }
  constexpr std::size_t kMaxBroken = 1000;  // more give no new information, and need memory
  if (broken_.size() >= kMaxBroken) resumed = last - 1;
  resumed = std::min(resumed, last - 1);  // the End token stays
  leaveOut(first, resumed);
  resumedAt_ = resumed;
  return resumed;
}

void SyntaxErrors::leaveOut(const Token* first, const Token* last) {
  BrokenStretch stretch;
  if (last > first) stretch.span = cover(first->span, (last - 1)->span);
  for (const Token* t = first; t < last; ++t)
    if (t->kind == TokenKind::Name && !isReserved(t->text)) stretch.names.push_back(t->text);
  broken_.push_back(std::move(stretch));
}

}  // namespace af2::dsl
