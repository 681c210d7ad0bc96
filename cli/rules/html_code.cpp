#include "cli/rules/html_code.h"

#include <algorithm>
#include <vector>

#include "dsl/syntax/lexer.h"
#include "dsl/text/keywords.h"

namespace af2::cli {
namespace {

struct Mark {
  dsl::Span span;
  const char* style;  ///< CSS class of the stretch
};

bool isKeyword(std::string_view word) { return dsl::isClauseWord(word) || dsl::isReserved(word); }

const char* styleOf(const dsl::Token& token) {
  switch (token.kind) {
    case dsl::TokenKind::Name:
      return isKeyword(token.text) ? "k" : nullptr;
    case dsl::TokenKind::Number:
      return "n";
    case dsl::TokenKind::String:
      return "s";
    default:
      return nullptr;
  }
}

std::vector<Mark> marksOf(const dsl::SourceText& source) {
  dsl::DiagnosticList ignored;
  const dsl::TokenList list = dsl::readTokens(source, ignored);
  std::vector<Mark> marks;
  for (const dsl::Token& token : list.tokens) {
    if (const char* style = styleOf(token)) marks.push_back({token.span, style});
  }
  for (const dsl::Comment& comment : list.comments) marks.push_back({comment.span, "c"});
  std::ranges::sort(marks, {}, [](const Mark& mark) { return mark.span.begin; });
  return marks;
}

}  // namespace

std::string escapeHtml(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else {
      out += c;
    }
  }
  return out;
}

std::string codeHtml(const dsl::SourceText& source, dsl::Span part) {
  std::string out;
  std::uint32_t at = part.begin;
  const auto plain = [&](std::uint32_t end) {
    out += escapeHtml(source.text().substr(at, end - at));
    at = end;
  };
  for (const Mark& mark : marksOf(source)) {
    if (mark.span.begin < at || mark.span.end > part.end) continue;
    plain(mark.span.begin);
    out += std::string("<i class=\"") + mark.style + "\">";
    plain(mark.span.end);
    out += "</i>";
  }
  plain(part.end);
  return out;
}

}  // namespace af2::cli
