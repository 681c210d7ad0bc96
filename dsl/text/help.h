// The way out that a diagnostic tells, together with the change of the text that takes it.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "dsl/text/diagnostic.h"
#include "dsl/text/source_text.h"

namespace af2::dsl {

/// What becomes of the stretch of text that a diagnostic is about.
struct Remedy {
  enum class Where {
    Word,    ///< `word`, where it first stands in the stretch, becomes `text`
    Whole,   ///< the stretch becomes `text`
    Before,  ///< `text` is put in before the stretch
    Behind,  ///< and behind it
    Top,     ///< and at the top of the file
  };
  Where where = Where::Whole;
  std::string text;
  std::string word = {};
};

/// A sentence, and perhaps what it says as a change of the text.
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

/// More words around the same remedy.
inline Help operator+(const std::string& before, const Help& help) {
  const std::string text = before + help.text();
  return help.remedy() ? Help(text, *help.remedy()) : Help(text);
}

/// Gives a diagnostic about a stretch of a text its help, and the edit that goes with it.
void setHelp(Diagnostic& diagnostic, const SourceText& source, Span span, const Help& help);

/// The edit that a remedy is for a stretch; nothing where its word does not stand there.
std::optional<SuggestedEdit> editOf(const SourceText& source, Span span, const Remedy& remedy);

}  // namespace af2::dsl
