// A file from its text to its tree: limits, words, version, items, documentation.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "dsl/syntax/early_braces.h"
#include "dsl/syntax/grammar.h"
#include "dsl/syntax/items.h"
#include "dsl/syntax/lexer.h"
#include "dsl/syntax/syntax_errors.h"
#include "dsl/syntax/version.h"

namespace af2::dsl {
namespace {

constexpr const char* kSplit = "split it, and join the parts with `import` and `use`";

bool endsStatement(const Token& token) {
  return token.is(";") || token.is("{") || token.is("}") || token.kind == TokenKind::End;
}

/// The depth that an operator adds to its tree.
int weightOf(const Token& token) {
  const bool isNested = token.is("^") || token.is("if");  // sums are long, but not deep
  const bool isWord = token.is("and") || token.is("or") || token.is("not");
  const bool isSymbol =
      token.kind == TokenKind::Symbol && !token.is("(") && !token.is(")") && !token.is(",");
  return isNested ? 10 : isSymbol || isWord;
}

/// The first token of a statement at which brackets or operators exceed the limit; null if there is
/// none. The limit exists because the parser and the code that traverses the tree are recursive and
/// need stack.
const Token* tooDeepAt(const Token* first, const ParseLimits& limits, const char*& fault) {
  int brackets = 0, operators = 0;
  for (const Token* t = first; !endsStatement(*t); ++t) {
    brackets = std::max(0, brackets + t->is("(") - t->is(")"));
    operators += weightOf(*t);
    if (brackets <= limits.nesting && operators <= limits.operators) continue;
    fault = brackets > limits.nesting ? "brackets are nested too deep here"
                                      : "this expression is too long";
    return t;
  }
  return nullptr;
}

/// Leaves out statements that exceed the limits. Returns false if nothing can be read.
bool keepWithinLimits(std::vector<Token>& tokens, const ParseLimits& limits, SyntaxErrors& errors) {
  constexpr const char* kHelp = "name parts of it with `let`, `const` or `def`";
  std::vector<std::uint8_t> isLeftOut(tokens.size());
  const Token* const first = tokens.data();
  int braces = 0;
  for (const Token* t = first; t < first + tokens.size(); ++t) {
    const char* fault = nullptr;
    const Token* at = tooDeepAt(t, limits, fault);
    const Token* end = t;
    while (!endsStatement(*end)) ++end;
    if (at) {
      errors.tell(Code::LimitExceeded, at->span, fault, kHelp);
      errors.leaveOut(t, end);
      std::fill(isLeftOut.begin() + (t - first), isLeftOut.begin() + (end - first), 1);
      isLeftOut[static_cast<std::size_t>(end - first)] = end->is(";");
    }
    t = end;
    braces = std::max(0, braces + t->is("{") - t->is("}"));
    if (braces > limits.nesting) {
      errors.tell(Code::LimitExceeded, t->span, "brackets are nested too deep here", kHelp);
      return false;
    }
  }
  std::erase_if(tokens, [&](const Token& token) {
    return isLeftOut[static_cast<std::size_t>(&token - first)] != 0;
  });
  return true;
}

/// `##` documents what follows it.
void attachDocs(File& file, const std::vector<Token>& tokens) {
  std::size_t t = 0;
  for (Item& item : file.items) {
    while (t < tokens.size() && tokens[t].span.begin < item.span.begin) ++t;
    if (t == tokens.size() || tokens[t].doc.empty()) continue;
    std::visit(
        [&](auto& value) {
          if constexpr (requires { value.doc; }) value.doc = tokens[t].doc;
        },
        item.content);
  }
}

}  // namespace

ParsedFile parseFile(const SourceText& source, DiagnosticList& diagnostics,
                     const ParseLimits& limits) {
  SyntaxErrors errors(source, diagnostics);
  ParsedFile result;
  if (source.text().size() > limits.bytes) {
    errors.tell(Code::LimitExceeded, {0, 0},
                "the file is larger than " + std::to_string(limits.bytes >> 20) + " MiB", kSplit);
    return result;
  }
  DiagnosticList lexical;
  TokenList words = readTokens(source, lexical, limits.words);
  result.comments = std::move(words.comments);
  if (words.isCut) {
    errors.tell(Code::LimitExceeded, words.tokens.back().span,
                "the file has more than " + std::to_string(limits.words) + " words", kSplit);
    return result;
  }
  if (!words.isText) diagnostics.append(std::move(lexical));
  if (!words.isText || !keepWithinLimits(words.tokens, limits, errors)) return result;
  const Token* first = readVersion(words.tokens, errors);
  if (!first) return result;  // not a rule file, so its words are not checked
  diagnostics.append(std::move(lexical));
  const auto begin = static_cast<std::size_t>(first - words.tokens.data());
  leaveOutEarlyBraces(words.tokens, errors);  // none stands before `begin`
  first = words.tokens.data() + begin;
  parseItems(first, words.tokens.data() + words.tokens.size(), errors, result.file);
  attachDocs(result.file, words.tokens);
  result.broken = errors.takeBroken();
  return result;
}

}  // namespace af2::dsl
