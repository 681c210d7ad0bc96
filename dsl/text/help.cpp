#include "dsl/text/help.h"

#include <string_view>

#include "dsl/text/characters.h"

namespace af2::dsl {
namespace {

/// Position of `word` as a whole word in the text; npos if there is none.
std::size_t findWord(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || !isNamePart(text[at - 1]) || !isNamePart(word.front());
    const bool ends = end == text.size() || !isNamePart(text[end]) || !isNamePart(word.back());
    if (begins && ends) return at;
  }
  return std::string_view::npos;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \n"), last = text.find_last_not_of(" \n");
  return first == text.npos ? std::string() : text.substr(first, last - first + 1);
}

}  // namespace

std::optional<SuggestedEdit> editOf(const SourceText& source, Span span, const Remedy& remedy) {
  const std::string text(source.text().substr(span.begin, span.end - span.begin));
  switch (remedy.where) {
    case Remedy::Where::Word: {
      const std::size_t at = remedy.word.empty() ? text.npos : findWord(text, remedy.word);
      if (at == text.npos || remedy.word == remedy.text) return std::nullopt;
      const auto begin = span.begin + static_cast<std::uint32_t>(at);
      const Span word{begin, begin + static_cast<std::uint32_t>(remedy.word.size())};
      return SuggestedEdit{placeOf(source, word), remedy.text,
                           "'" + remedy.word + "' becomes '" + remedy.text + "'"};
    }
    case Remedy::Where::Whole:
      return SuggestedEdit{placeOf(source, span), remedy.text,
                           remedy.text.empty() ? "'" + text + "' deleted"
                                               : "'" + text + "' becomes '" + remedy.text + "'"};
    case Remedy::Where::Before:
      return SuggestedEdit{placeOf(source, {span.begin, span.begin}), remedy.text,
                           "'" + trimmed(remedy.text) + "' added"};
    case Remedy::Where::Top:
      return SuggestedEdit{placeOf(source, {0, 0}), remedy.text,
                           "'" + trimmed(remedy.text) + "' added"};
    case Remedy::Where::Behind:
      return SuggestedEdit{placeOf(source, {span.end, span.end}), remedy.text,
                           "'" + trimmed(remedy.text) + "' added"};
  }
  return std::nullopt;
}

void setHelp(Diagnostic& diagnostic, const SourceText& source, Span span, const Help& help) {
  diagnostic.help = help.text();
  if (!help.remedy()) return;
  if (auto edit = editOf(source, span, *help.remedy()))
    diagnostic.edits.push_back(std::move(*edit));
}

}  // namespace af2::dsl
