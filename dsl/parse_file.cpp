// A file from its text to its tree: limits, words, version, items, documentation.
#include <algorithm>

#include "dsl/grammar.h"
#include "dsl/items.h"
#include "dsl/lexer.h"
#include "dsl/syntax_errors.h"
#include "dsl/version.h"

namespace af2::dsl {
namespace {

constexpr const char* kSplit = "split it, and join the parts with `import` and `use`";

/// Whether brackets and operators stay within what the stack can hold; the grammar and all that
/// walks over the tree are recursive.
bool isWithinLimits(const std::vector<Token>& tokens, const ParseLimits& limits,
                    SyntaxErrors& errors) {
  int nesting = 0, operators = 0;
  for (const Token& token : tokens) {
    if (token.is("(") || token.is("{"))
      ++nesting;
    else if (token.is(")") || token.is("}"))
      nesting = std::max(0, nesting - 1);
    if (token.is(";") || token.is("{") || token.is("}"))
      operators = 0;
    else if (token.kind == TokenKind::Symbol || token.is("and") || token.is("or") ||
             token.is("not") || token.is("if"))
      operators += !(token.is("(") || token.is(")") || token.is(","));
    if (token.is("^") || token.is("if")) operators += 9;  // nested, where sums are only long
    if (nesting > limits.nesting || operators > limits.operators) {
      errors.tell("S6", token.span,
                  nesting > limits.nesting ? "brackets are nested too deep here"
                                           : "this expression is too long",
                  "name parts of it with `let`, `const` or `def`");
      return false;
    }
  }
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
    errors.tell("S6", {0, 0},
                "the file is larger than " + std::to_string(limits.bytes >> 20) + " MiB", kSplit);
    return result;
  }
  DiagnosticList lexical;
  TokenList words = readTokens(source, lexical, limits.words);
  result.comments = std::move(words.comments);
  if (words.isCut) {
    errors.tell("S6", words.tokens.back().span,
                "the file has more than " + std::to_string(limits.words) + " words", kSplit);
    return result;
  }
  if (!words.isText) diagnostics.append(std::move(lexical));
  if (!words.isText || !isWithinLimits(words.tokens, limits, errors)) return result;
  const Token* first = readVersion(words.tokens, errors);
  if (!first) return result;  // its words make no sense, so they need not be spelt well
  diagnostics.append(std::move(lexical));
  parseItems(first, words.tokens.data() + words.tokens.size(), errors, result.file);
  attachDocs(result.file, words.tokens);
  result.broken = errors.takeBroken();
  return result;
}

}  // namespace af2::dsl
