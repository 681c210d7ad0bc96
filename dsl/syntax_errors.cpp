#include "dsl/syntax_errors.h"

#include <algorithm>

#include "dsl/words.h"

namespace af2::dsl {
namespace {

bool isOneOf(const Token& token, std::span<const std::string_view> words) {
  return token.kind == TokenKind::Name &&
         std::find(words.begin(), words.end(), token.text) != words.end();
}

std::span<const std::string_view> wordsOf(SyntaxUnit unit) {
  switch (unit) {
    case SyntaxUnit::Item:
      return itemWords();
    case SyntaxUnit::Setting:
      return settingWords();
    case SyntaxUnit::TestClause:
      return testWords();
    default:
      return clauseWords();
  }
}

std::string found(const Token& token) {
  switch (token.kind) {
    case TokenKind::End:
      return "the end of the file";
    case TokenKind::Number:
      return "the number " + token.text.substr(0, 40);
    case TokenKind::String:
      return "the string \"" + token.text.substr(0, 40) + "\"";
    default:
      return "'" + token.text.substr(0, 40) + "'";
  }
}

bool isSymbolName(const std::string& wanted) {
  return !wanted.empty() && wanted.find(' ') == std::string::npos;
}

std::string quoted(const std::string& wanted) {
  return isSymbolName(wanted) ? "'" + wanted + "'" : wanted;
}

bool isComparison(const Token& token) {
  for (const char* symbol : {"<", "<=", ">", ">=", "==", "!="})
    if (token.is(symbol)) return true;
  return false;
}

/// Where a `rule`, test or other block of which the beginning is known may be gone on with.
/// Tests name rules as items do; there only the beginning of a line counts.
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
      if (--braces <= 0) return t + 1;
    } else if (t->is(";") && braces == 0) {
      // A header that ends in `;` has no body; what was meant as one cannot be told from clauses.
      return t + 1;
    } else if (braces == 0 && t > first && t->startsLine && isOneOf(*t, wordsOf(unit)) &&
               unit != SyntaxUnit::Item && unit != SyntaxUnit::RuleHeader) {
      return t;
    }
  }
}

}  // namespace

bool SyntaxErrors::beginsItem(const Token* token) {
  if (!isOneOf(*token, itemWords())) return false;
  const Token& next = token[1];  // the list ends with End, which is no item word
  if (token->is("import") || token->is("rule") || token->is("ruleset") || token->is("test") ||
      token->is("property"))
    return next.kind == TokenKind::String;
  return next.kind == TokenKind::Name && !next.is("in");
}

void SyntaxErrors::tell(const char* code, Span span, std::string message, std::string help) {
  Diagnostic d;
  d.code = code;
  d.message = std::move(message);
  d.place = placeOf(source_, span);
  d.help = std::move(help);
  diagnostics_.add(std::move(d));
}

void SyntaxErrors::tellUnknownWord(const Token* where, const std::string& wanted) {
  const auto words = wanted == kItem         ? itemWords()
                     : wanted == kSetting    ? settingWords()
                     : wanted == kTestClause ? testWords()
                                             : clauseWords();
  const std::vector<std::string> known(words.begin(), words.end());
  const char* place = wanted == kItem         ? "at the top level of a file"
                      : wanted == kSetting    ? "in a rule set"
                      : wanted == kTestClause ? "in a test"
                                              : "in a rule";
  std::string list;
  for (const std::string& word : known) list += (list.empty() ? "" : ", ") + word;
  if (where->is("weld")) {
    tell("S4", where->span, "'weld' is reserved; rules cannot join vertices yet",
         "remove the clause");
    return;
  }
  if (where->is(";")) {
    tell("S1", where->span, "this ';' ends nothing",
         "delete it; what ends in a brace takes no ';'");
    return;
  }
  if (where->kind != TokenKind::Name) {
    tell("S1", where->span, "unexpected " + found(*where) + " " + place,
         std::string("here stands one of: ") + list);
    return;
  }
  std::string help = didYouMean(where->text, known);
  if (help.empty()) help = std::string("here stands one of: ") + list;
  const bool isElsewhere = isReserved(where->text);
  tell("S4", where->span,
       "'" + where->text.substr(0, 60) + "' " + (isElsewhere ? "cannot stand " : "means nothing ") +
           place,
       std::move(help));
}

void SyntaxErrors::tellMissing(SyntaxUnit unit, const Token* where, const std::string& wanted) {
  const Token* before = where - 1;  // a unit has begun, so there is one
  const Span behind{before->span.end > 0 ? before->span.end - 1 : 0, before->span.end};
  const Span here = where->kind == TokenKind::End ? behind : where->span;

  if (wanted == kNoSecondFade)
    return tell("S8", here, "a corner or shape fades only once; '=>' does not chain",
                "write `preferred => limit`; use lerp for what lies between");
  if (wanted == "}")
    return tell("S5", here,
                std::string(unit == SyntaxUnit::MirrorPart ? "this mirror" : "this block") +
                    " is not closed: '}' is missing before " + found(*where),
                "add '}'");
  if (wanted == ";" && where->startsLine)
    return tell("S2", behind, "';' is missing after '" + before->text.substr(0, 40) + "'",
                "end the clause with ';'");
  if (wanted == ";" && isComparison(*where))
    return tell("S1", here, "comparisons do not chain",
                "write `a < b and b < c`, or `x in low..high`");
  if (wanted == ";" && where->is("="))
    return tell("S1", here, "'=' does not compare",
                "write '==' to ask whether two things are equal");
  if (wanted == ";" && (where->is("&") || where->is("|")))
    return tell("S1", here, "unexpected " + found(*where), "conditions are joined by `and`, `or`");
  if (wanted == ";" && where->is(")"))
    return tell("S1", here, "this ')' closes nothing", "delete it");
  const bool isDoubled = where->span.begin == before->span.end && where->text == before->text;
  if (isDoubled && (where->is("&") || where->is("|")))
    return tell("S1", cover(before->span, where->span),
                "'" + where->text + where->text + "' means nothing",
                "conditions are joined by `and`, `or`");
  if (wanted == "an expression")
    return tell("S3", here,
                "an expression is missing between '" + before->text.substr(0, 40) + "' and " +
                    found(*where),
                where->kind == TokenKind::Name && isReserved(where->text)
                    ? "'" + where->text + "' is a word of the language and cannot be a name"
                    : "write a number, a point, a name, ...");
  if (where->kind == TokenKind::Name && isReserved(where->text) &&
      wanted.find("name") != std::string::npos)
    return tell("S9", here, "'" + where->text + "' is a word of the language and cannot be a name",
                "choose another name");
  if (where->startsLine && isSymbolName(wanted))
    return tell("S1", behind,
                "'" + wanted + "' is missing after '" + before->text.substr(0, 40) + "'",
                "add '" + wanted + "'");
  tell("S1", here, "expected " + quoted(wanted) + ", found " + found(*where),
       where->kind == TokenKind::Name ? didYouMean(where->text, {wanted}) : "");
}

const Token* SyntaxErrors::tellAndRecover(SyntaxUnit unit, const Token* first, const Token* where,
                                          const Token* last, const std::string& wanted) {
  const bool isTold = where->isDoubtful || (where > first && (where - 1)->isDoubtful);
  if (!isTold && (where != resumedAt_ || where == first)) {
    if (wanted == kItem || wanted == kClause || wanted == kSetting || wanted == kTestClause)
      tellUnknownWord(where, wanted);
    else
      tellMissing(unit, where, wanted);
  }
  const Token* resumed = skipUnit(unit, first, where == first ? first + 1 : where);
  if (where == first && !endsBlockEarly(first, unit)) {
    // The first word itself is wrong; what hangs on it goes with it.
    resumed = skipUnit(unit, first, first->is("{") || first->is(";") ? first : first + 1);
  }
  resumed = std::min(resumed, last - 1);  // the End token stays
  BrokenStretch stretch;
  if (resumed > first) stretch.span = cover(first->span, (resumed - 1)->span);
  for (const Token* t = first; t < resumed; ++t)
    if (t->kind == TokenKind::Name && !isReserved(t->text)) stretch.names.push_back(t->text);
  broken_.push_back(std::move(stretch));
  resumedAt_ = resumed;
  return resumed;
}

}  // namespace af2::dsl
