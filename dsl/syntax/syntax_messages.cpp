// Messages about parts that could not be read: the fault as its author sees it, and the form.
#include <algorithm>
#include <optional>

#include "dsl/syntax/syntax_errors.h"
#include "dsl/text/keywords.h"
#include "dsl/text/words.h"

namespace af2::dsl {
namespace {

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

bool beginsOperand(const Token& token) {
  return token.kind == TokenKind::Number || token.is("(") ||
         (token.kind == TokenKind::Name && !isReserved(token.text));
}

bool endsOperand(const Token& token) {
  return token.kind == TokenKind::Number || token.is(")") ||
         (token.kind == TokenKind::Name && !isReserved(token.text));
}

/// The last character of the word before: the place of something that is missing at the end of a
/// line.
Span behind(const Token* where) {
  const Token* before = where - 1;  // a unit has begun, so there is one
  return {before->span.end > 0 ? before->span.end - 1 : 0, before->span.end};
}

Span placeFor(const Token* where) {
  return where->kind == TokenKind::End ? behind(where) : where->span;
}

struct Fault {
  Code code;
  Span span;
  std::string message;
  Help help;
};

/// An operator of another language that consists of two symbols of this language.
struct Spelling {
  const char *first, *second, *meaning;
};

constexpr Spelling kSpellings[]{
    {"&", "&", "conditions are joined by `and`, `or`"},
    {"|", "|", "conditions are joined by `and`, `or`"},
    {"*", "*", "powers are written x^2"},
    {"<", ">", "unequal is written !="},
    {"=", "<", "at most is written <="},
    {"<", "-", "an edge is written a -> b"},
    {"-", ">", "an arrow is written -> without a space"},
    {"=", ">", "a fade is written => without a space"},
    {":", "=", "write = alone"},
    {"+", "=", "values cannot change; give the new value another name"},
    {"-", "=", "values cannot change; give the new value another name"},
    {"+", "+", "write one +"},
};

/// The fault is the second symbol of a pair, or the first.
std::optional<Fault> foreignOperator(const Token* where) {
  for (const Token* first : {where - 1, where}) {
    const Token* second = first + 1;
    if (first->kind != TokenKind::Symbol || second->kind != TokenKind::Symbol) continue;
    for (const Spelling& s : kSpellings)
      if (first->is(s.first) && second->is(s.second))
        return Fault{Code::UnexpectedText, cover(first->span, second->span),
                     "'" + first->text + (first->span.end == second->span.begin ? "" : " ") +
                         second->text + "' has no meaning here",
                     s.meaning};
  }
  return std::nullopt;
}

bool isUnitWord(SyntaxUnit unit, const Token& token) {
  if (token.kind != TokenKind::Name) return false;
  return unit == SyntaxUnit::RuleHeader ? token.is("rule")
                                        : findKeyword(blockOf(unit), token.text) != nullptr;
}

/// Whether another unit, or the end of the block, clearly follows.
bool isBehindUnit(SyntaxUnit unit, const Token* where) {
  const bool beginsNext =
      SyntaxErrors::beginsItem(where) || (unit != SyntaxUnit::Item && isUnitWord(unit, *where));
  return beginsNext || where->is("}") || where->kind == TokenKind::End;
}

Fault noEnd(SyntaxUnit unit, const Token* where) {
  return {Code::MissingSemicolon, behind(where),
          "';' is missing after '" + (where - 1)->text.substr(0, 40) + "'",
          Help(unit == SyntaxUnit::Item ? "end it with ';'" : "end the clause with ';'",
               {Remedy::Where::Behind, ";"})};
}

/// `1,5` without a blank, at `where` or a little before it in the same unit.
std::optional<Fault> decimalComma(const Token* first, const Token* where) {
  constexpr std::ptrdiff_t kFarthest = 50;  // words
  for (const Token* comma = where; comma > first && where - comma < kFarthest; --comma) {
    const Token &before = comma[-1], &after = comma[1];
    const bool isTight =
        before.span.end == comma->span.begin && comma->span.end == after.span.begin;
    if (!comma->is(",") || !isTight || before.kind != TokenKind::Number ||
        after.kind != TokenKind::Number || before.text.find('.') != std::string::npos)
      continue;
    const std::string meant = before.text + "." + after.text;
    return Fault{Code::UnexpectedText, cover(before.span, after.span),
                 "write decimals with a point, not a comma",
                 Help("did you mean " + meant + "?", {Remedy::Where::Whole, meant})};
  }
  return std::nullopt;
}

/// The fault if the end of a clause was expected.
std::optional<Fault> missingEnd(SyntaxUnit unit, const Token* first, const Token* where) {
  if (where->startsLine || isBehindUnit(unit, where)) return noEnd(unit, where);
  if (first->is("zone") && (where->is("=") || where->is("->")))
    return Fault{Code::UnexpectedText, where->span, found(*where) + " does not fade",
                 Help("did you mean '=>'? `preferred => limit`", {Remedy::Where::Whole, "=>"})};
  if (isComparison(*where))
    return Fault{Code::UnexpectedText, where->span, "comparisons cannot be chained",
                 "write `a < b and b < c`, or `x in low..high`"};
  if (where->is("="))
    return Fault{
        Code::UnexpectedText, where->span, "'=' does not compare",
        Help("write '==' to ask whether two things are equal", {Remedy::Where::Whole, "=="})};
  if (where->is("=>"))
    return first->is("require") ? Fault{Code::UnexpectedText, where->span, "'=>' does not compare",
                                        "at least is written >="}
                                : Fault{Code::UnexpectedText, where->span,
                                        "'=>' belongs to the corners and shapes of a zone",
                                        "only a zone fades from a preferred to a limiting form"};
  if (where->is(",") && (first->is("const") || first->is("def") || first->is("metric")))
    return Fault{Code::UnexpectedText, where->span, "a `" + first->text + "` defines one name",
                 "end it with ';', and write another `" + first->text + "` for the next one"};
  if (where->is("&") || where->is("|"))
    return Fault{Code::UnexpectedText, where->span, "unexpected " + found(*where),
                 "conditions are joined by `and`, `or`"};
  if (where->is(")"))
    return Fault{Code::UnexpectedText, where->span, "this ')' closes nothing",
                 Help("delete it", {Remedy::Where::Whole, ""})};
  if (where->is(":"))
    return Fault{Code::MissingSemicolon, where->span, "';' is missing: found ':'",
                 "end the clause with ';'"};
  return std::nullopt;
}

/// The fault if two operands follow each other without an operator.
std::optional<Fault> missingBetween(SyntaxUnit unit, const Token* first, const Token* where,
                                    const std::string& wanted) {
  const Token* before = where - 1;
  if (unit == SyntaxUnit::TestClause && (before - 1)->is("expect")) {
    const bool isCount = before->is("elements");
    if (isCount || before->is("score"))
      return Fault{
          Code::UnexpectedText, where->span,
          std::string("expected ") + (isCount ? "a whole number" : "a comparison") + ", found " +
              found(*where),
          isCount ? "it is written `expect elements 2;`" : "it is written `expect score < 0.1;`"};
  }
  const bool isWord =
      first->is("scale") || first->is("parity") || first->is("finish") || first->is("elements");
  if (unit == SyntaxUnit::Setting && isWord) return std::nullopt;
  const bool isGap = endsOperand(*before) && beginsOperand(*where) && before > first;
  if (!isGap || (wanted != ";" && wanted != ")" && wanted != "->" && wanted != ","))
    return std::nullopt;
  const std::string between =
      " is missing between '" + before->text.substr(0, 40) + "' and " + found(*where);
  const bool isBetweenVertices = wanted == "->" || wanted == ";";
  if (first->is("front") && isBetweenVertices &&
      (unit == SyntaxUnit::Clause || unit == SyntaxUnit::TestClause))
    return Fault{Code::UnexpectedText, where->span, "'->'" + between,
                 "edges are written a -> b; chains are separated by ','"};
  if (wanted == "->") return std::nullopt;
  return Fault{Code::UnexpectedText, where->span, "an operator or ','" + between,
               "write multiplication with '*'; separate arguments by ','"};
}

/// Whether the names of a unit are defined elsewhere, so that faults in them are reported there.
bool usesNames(const Token& head) {
  for (const char* word : {"at", "let", "new", "const", "def", "metric", "template", "import"})
    if (head.is(word)) return false;
  return true;
}

/// The opening bracket that should be closed before `where`.
const Token* openBracket(const Token* first, const Token* where) {
  int closed = 0;
  for (const Token* t = where; t-- > first;) {
    closed += t->is(")") - t->is("(");
    if (closed < 0) return t;
  }
  return nullptr;
}

std::string formHelp(SyntaxUnit unit, const Token* first, const Token* where,
                     const std::string& wanted) {
  if (wanted == ".." && unit != SyntaxUnit::Setting && !first->is("property"))
    return "a range is written low..high, as in `x in 0.5..2`";
  if (wanted == "'at', 'quality' or 'cost'")
    return "a mirror image may have other tolerances, levels and costs; everything else follows "
           "from its "
           "rule";
  if (wanted == "then" || wanted == "else")
    return "a choice is written `if condition then x else y`";
  if (first->is("expect") && first[1].is("new")) return "it is written `expect new 1 at (x, y);`";
  if (first->is("expect") && first[1].is("front"))
    return "it is written `expect front only p -> new 1 -> r;`";
  const bool isFamily =
      wanted == "in" || wanted == "values in parentheses" || (where - 1)->is("for");
  if (unit == SyntaxUnit::RuleHeader && isFamily && first->is("rule"))
    return "it is written `rule \"title\" for (k, h) in (1, 0.5), (2, 0.3) quality k { ... }`";
  const BlockKind block = unit == SyntaxUnit::RuleHeader ? BlockKind::File : blockOf(unit);
  const Keyword* keyword = findKeyword(block, first->text);
  return keyword ? "it is written " + shownForm(*keyword) : std::string();
}

}  // namespace

bool SyntaxErrors::tellMissingEnd(SyntaxUnit unit, const Token* where) {
  if (!isBehindUnit(unit, where) || where->isDoubtful || (where - 1)->isDoubtful) return false;
  const Fault fault = noEnd(unit, where);
  tell(fault.code, fault.span, fault.message, fault.help);
  return true;
}

void SyntaxErrors::tellMissingBrace(const Token* clause) {
  tell(Code::UnexpectedText, behind(clause),
       "'{' is missing after '" + (clause - 1)->text.substr(0, 40) + "'",
       "the clauses of a rule belong in braces");
}

void SyntaxErrors::tellUnknownWord(const Token* where, const std::string& wanted) {
  const auto words = keywordsOf(wanted == kItem         ? BlockKind::File
                                : wanted == kSetting    ? BlockKind::RuleSet
                                : wanted == kTestClause ? BlockKind::Test
                                                        : BlockKind::Rule);
  const char* place = wanted == kItem         ? "at the top level of a file"
                      : wanted == kSetting    ? "in a rule set"
                      : wanted == kTestClause ? "in a test"
                                              : "in a rule";
  const std::vector<std::string> known(words.begin(), words.end());
  std::string list;
  for (const std::string& word : known) list += (list.empty() ? "" : ", ") + word;
  list = "expected one of: " + list;
  if (where == version_ || where == toldWord_) return;
  // These are clauses of a block that was assumed to have ended above.
  if (wanted == kItem && missingBraces_ > 0 && isClauseWord(where->text)) return;
  if (where->is("af2"))
    return tell(Code::MissingVersion, where->span,
                "the version of the language is given once, at the top", "delete it here");
  if (where->is("weld"))
    return tell(Code::UnknownClause, where->span,
                "'weld' is reserved; rules cannot join vertices yet", "remove the clause");
  if (where->is(";"))
    return tell(
        Code::UnexpectedText, where->span, "this ';' ends nothing",
        Help("delete it; a block that ends with a brace takes no ';'", {Remedy::Where::Whole, ""}));
  if (where->is("}") && missingBraces_ > 0) {
    --missingBraces_;  // belongs to a block that was assumed to have ended above
    return;
  }
  if (where->is("}"))
    return tell(Code::UnexpectedText, where->span, "this '}' closes nothing",
                Help("delete it, or look above for an extra '}'", {Remedy::Where::Whole, ""}));
  if (where->kind != TokenKind::Name)
    return tell(Code::UnexpectedText, where->span, "unexpected " + found(*where) + " " + place,
                list);
  Help help = habitOf(where->text);
  if (wanted == kClause && where->is("quality"))
    help = "the levels belong before the '{': `rule \"title\" quality 1 { ... }`";
  if (help.empty()) help = didYouMean(where->text, known);
  const bool isElsewhere = isReserved(where->text) || (help.empty() && isClauseWord(where->text));
  tell(Code::UnknownClause, where->span,
       "'" + where->text.substr(0, 60) + "' " +
           (isElsewhere ? "is not allowed " : "has no meaning ") + place,
       help.empty() ? list : help);
}

void SyntaxErrors::tellMissing(SyntaxUnit unit, const Token* first, const Token* where,
                               const std::string& wanted) {
  const Token* before = where - 1;
  const Span here = placeFor(where);
  const auto tellFault = [&](const Fault& f) { tell(f.code, f.span, f.message, f.help); };

  if (wanted == kNoSecondFade)
    return tell(Code::ChainedFade, here,
                "a corner or shape fades only once; '=>' cannot be chained",
                "write `preferred => limit`; use lerp for points between them");
  if (wanted == "}") return tellUnclosed(unit, first, where);
  if (const auto fault = foreignOperator(where)) return tellFault(*fault);
  if (where->is(",") && (wanted == ";" || wanted == ")"))
    if (const auto fault = decimalComma(first, where)) return tellFault(*fault);
  if (wanted == ";")
    if (const auto fault = missingEnd(unit, first, where)) return tellFault(*fault);
  if (const auto fault = missingBetween(unit, first, where, wanted)) return tellFault(*fault);

  const bool isElement = first->is("tri") || first->is("quad") || first->is("poly");
  if (where->is(",") && isElement && unit == SyntaxUnit::Clause)
    return tell(Code::UnexpectedText, here, "the corners of an element are separated by spaces",
                "it is written " + shownForm(*findKeyword(BlockKind::Rule, first->text)));
  const std::string help = formHelp(unit, first, where, wanted);
  const bool isWord = where->kind == TokenKind::Name && isReserved(where->text);
  if (wanted == "quality" && where->is("{") && where[1].is("quality")) {
    toldWord_ = where + 1;
    return tell(Code::UnexpectedText, where[1].span, "the levels of a rule belong before its '{'",
                "it is written `rule \"title\" quality 1 { ... }`");
  }
  // One vertex is not a chain. The other parts of the clause usually have the same fault, so it is
  // reported once.
  if (wanted == "->" && (where->is(",") || where->is(";")) && unit != SyntaxUnit::Setting) {
    if (shortChainOf_ == first) return;
    shortChainOf_ = first;
  }
  if (wanted == ")" && where->is("..") && (unit == SyntaxUnit::RuleHeader || first->is("rule")))
    return tell(Code::UnexpectedText, where->span, "a family has no ranges",
                "list its values: `for (k) in (1), (2), (3)`");
  if (isWord && wordsToldAsNames_.contains(where->text) && usesNames(*first)) return;
  if (wanted == kExpressionWanted)
    return tell(Code::MissingExpression, here,
                "an expression is missing between '" + before->text.substr(0, 40) + "' and " +
                    found(*where),
                isWord ? "'" + where->text + "' is a keyword and cannot be a name"
                       : "write a number, a point, a name, ...");
  if (isWord && wanted.find("name") != std::string::npos) wordsToldAsNames_.insert(where->text);
  if (isWord && wanted.find("name") != std::string::npos)
    return tell(Code::ReservedWord, here, "'" + where->text + "' is a keyword and cannot be a name",
                "choose another name");
  if (wanted == ")")
    if (const Token* open = openBracket(first, where))
      return tell(Code::UnexpectedText, where->startsLine ? behind(where) : here,
                  "')' is missing before " + found(*where), "close the bracket",
                  {{"it is opened here", placeOf(source_, open->span)}});
  if (where->startsLine && isSymbolName(wanted))
    return tell(Code::UnexpectedText, behind(where),
                "'" + wanted + "' is missing after '" + before->text.substr(0, 40) + "'", help);
  const Help guess = where->kind == TokenKind::Name ? didYouMean(where->text, {wanted}) : Help();
  tell(Code::UnexpectedText, here, "expected " + quoted(wanted) + ", found " + found(*where),
       guess.empty() ? Help(help) : guess);
}

void SyntaxErrors::tellUnclosed(SyntaxUnit unit, const Token* first, const Token* where) {
  const char* what = unit == SyntaxUnit::MirrorPart || first->is("mirror") ? "this mirror"
                     : first->is("meta")                                   ? "this meta"
                                                                           : "this block";
  tell(Code::UnclosedBlock, placeFor(where),
       std::string(what) + " is not closed: '}' is missing before " + found(*where),
       where->kind == TokenKind::End ? Help("add '}'", {Remedy::Where::Behind, "\n}"})
                                     : Help("add '}'", {Remedy::Where::Before, "}\n\n"}),
       {{"it begins here", placeOf(source_, first->span)}});
}

}  // namespace af2::dsl
