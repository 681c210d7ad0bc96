#include "dsl/syntax/version.h"

#include <algorithm>

#include "dsl/text/keywords.h"
#include "dsl/text/words.h"

namespace af2::dsl {
namespace {

constexpr const char* kForm = "write `af2 1;`";

bool isWhole(const Token& token) {
  return token.kind == TokenKind::Number && !token.isDoubtful &&
         token.text.find_first_not_of("0123456789") == std::string::npos;
}

/// Reads the words after `af2`, including the `;`.
const Token* readNumber(const Token* at, SyntaxErrors& errors) {
  const Token& version = at[1];
  if (!isWhole(version)) {
    const bool isLast = version.kind == TokenKind::End || version.startsLine;
    if (!version.isDoubtful)
      errors.tell(Code::MissingVersion, isLast ? at->span : cover(at->span, version.span),
                  "the version of the language is missing", kForm);
    const Token* first = at++;
    while (at->kind != TokenKind::End && !at->is(";") && !at->startsLine) ++at;
    return at > first && at->is(";") ? at + 1 : at;
  }
  if (version.number != 1)
    errors.tell(Code::MissingVersion, version.span,
                "this is version 1 of the language; the file asks for " + version.text, kForm);
  if (at[2].is(";")) return at + 3;
  errors.tell(Code::MissingSemicolon, version.span,
              "';' is missing after 'af2 " + version.text + "'", kForm);
  return at + 2;
}

bool isNetgens(const std::vector<Token>& tokens) {
  return std::ranges::any_of(tokens, [](const Token& t) {
    return t.is("endrule") || t.is("mappoints") || t.is("maplines");
  });
}

/// Reports a version that is misplaced, misspelt or missing.
const Token* tellMissing(const std::vector<Token>& tokens, SyntaxErrors& errors) {
  const Token* first = tokens.data();
  const char* const rule = "a rule file begins with `af2 1;`";
  if (isNetgens(tokens)) {
    errors.tell(Code::MissingVersion, first->span,
                "this is a rule file of Netgen; a rule file of AF2 begins with `af2 1;`",
                "`af2 import FILE` converts it to the language of AF2");
    return nullptr;
  }
  for (const Token& token : tokens) {
    if (!token.startsLine || !token.is("af2") || !isWhole((&token)[1])) continue;
    errors.tell(Code::MissingVersion, token.span, "`af2 1;` must be at the top of the file",
                "move it there");
    errors.expectVersionAt(&token);
    return first;
  }
  if (first->kind == TokenKind::End) {
    errors.tell(Code::MissingVersion, {0, 0}, "this file contains only spaces and comments",
                "a rule file begins with `af2 1;`");
    return nullptr;
  }
  if (!nearest(first->text, {"af2"}).empty() && !isClauseWord(first->text)) {
    errors.tell(Code::MissingVersion, first->span, rule, "did you mean `af2 1;`?");
    const Token* at = first + 1;
    while (at->kind != TokenKind::End && !at->is(";") && !at->startsLine) ++at;
    return at->is(";") ? at + 1 : at;
  }
  const auto items = keywordsOf(BlockKind::File);
  const bool isItem = SyntaxErrors::beginsItem(first) || isClauseWord(first->text) ||
                      !nearest(first->text, {items.begin(), items.end()}).empty();
  errors.tell(Code::MissingVersion, first->span,
              isItem ? rule : "this is not a rule file: a rule file begins with `af2 1;`",
              Help("add `af2 1;` as the first line", {Remedy::Where::Top, "af2 1;\n\n"}));
  return isItem ? first : nullptr;
}

}  // namespace

const Token* readVersion(const std::vector<Token>& tokens, SyntaxErrors& errors) {
  return tokens.front().is("af2") ? readNumber(tokens.data(), errors) : tellMissing(tokens, errors);
}

}  // namespace af2::dsl
