// The way out of a fault: a sentence, and the change of the text that carries it out.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "dsl/text/diagnostic.h"
#include "dsl/text/source_text.h"

namespace af2::dsl {

/// A change of the text that a diagnostic points at (here called the stretch).
struct Remedy {
  enum class Where {
    Word,    ///< replaces the first `word` in the stretch by `text`
    Whole,   ///< replaces the stretch by `text`
    Before,  ///< inserts `text` before the stretch
    Behind,  ///< inserts `text` after the stretch
    Top,     ///< inserts `text` at the top of the file
  };
  Where where = Where::Whole;
  std::string text;
  std::string word = {};
};

/// A sentence, and optionally the change of the text that it describes.
class Help {
 public:
  Help() = default;
  Help(const char* text) : text_(text) {}
  Help(std::string text) : text_(std::move(text)) {}
  Help(std::string text, Remedy remedy) : text_(std::move(text)), remedy_(std::move(remedy)) {}

  bool empty() const { return text_.empty(); }
  const std::string& text() const { return text_; }
  const std::optional<Remedy>& remedy() const { return remedy_; }

 private:
  std::string text_;
  std::optional<Remedy> remedy_;
};

/// The same remedy with more words around it.
inline Help operator+(const std::string& before, const Help& help) {
  const std::string text = before + help.text();
  return help.remedy() ? Help(text, *help.remedy()) : Help(text);
}

/// Adds the help, and its edit if there is one, to a diagnostic about a stretch of a text.
void setHelp(Diagnostic& diagnostic, const SourceText& source, Span span, const Help& help);

/// The edit that carries out a remedy on a stretch; nothing if the stretch does not contain its
/// word.
std::optional<SuggestedEdit> editOf(const SourceText& source, Span span, const Remedy& remedy);

}  // namespace af2::dsl
