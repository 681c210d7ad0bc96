#include "dsl/syntax/early_braces.h"

#include "dsl/text/keywords.h"

namespace af2::dsl {
namespace {

bool beginsClause(const Token& token) {
  return token.kind == TokenKind::Name && isClauseWord(token.text) &&
         !SyntaxErrors::beginsItem(&token);
}

/// Tests name rules as items do: `expect rule "..."`, `expect not rule "..."`.
bool beginsItem(const Token* token) {
  return SyntaxErrors::beginsItem(token) && !token[-1].is("expect") && !token[-1].is("not");
}

/// Whether a '}' without an opening brace after `from` comes before the next item.
bool isClosedAgain(const Token* from) {
  int depth = 0;
  for (const Token* t = from; t->kind != TokenKind::End; ++t) {
    if (depth == 0 && beginsItem(t)) return false;
    depth += t->is("{") - t->is("}");
    if (depth < 0) return true;
  }
  return false;
}

/// The clause that follows a '}'; null if there is none.
const Token* clauseBehind(const Token* brace) {
  const Token* next = brace + 1;
  while (next->is("}")) ++next;
  return beginsClause(*next) ? next : nullptr;
}

}  // namespace

void leaveOutEarlyBraces(std::vector<Token>& tokens, SyntaxErrors& errors) {
  constexpr int kMax =
      20;  // each requires a scan of the rest of the file, and more give no new information
  std::vector<const Token*> early;
  int depth = 0, looked = 0;
  for (const Token& token : tokens) {
    const bool mayBeEarly = token.is("}") && depth == 1 && looked < kMax;
    const Token* clause = mayBeEarly ? clauseBehind(&token) : nullptr;
    looked += clause != nullptr;
    if (clause && isClosedAgain(clause)) {
      errors.tell(Code::UnexpectedText, token.span,
                  "this '}' comes too early: '" + clause->text + "' continues the block",
                  Help("delete it", {Remedy::Where::Whole, ""}));
      early.push_back(&token);
      continue;
    }
    depth += token.is("{") - token.is("}");
    if (depth < 0) depth = 0;
  }
  for (; !early.empty(); early.pop_back())
    tokens.erase(tokens.begin() + (early.back() - tokens.data()));
}

}  // namespace af2::dsl
