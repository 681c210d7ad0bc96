// What is told about a rule file: place, fault, way out.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dsl/text/diagnostic_codes.h"
#include "dsl/text/source_text.h"
#include "engine/base/export.h"

namespace af2::dsl {

/// A place in a file, kept without the file.
struct DiagnosticPlace {
  std::string file;
  int line = 0, column = 0, endLine = 0,
      endColumn = 0;   ///< from 1; the end is exclusive; 0: no place
  std::string text;    ///< the line, or of a very long one what lies around the place
  int textColumn = 1;  ///< where in the line `text` begins
  bool operator==(const DiagnosticPlace&) const = default;
};

/// A further remark, perhaps about another place.
struct DiagnosticNote {
  enum class Kind {
    Remark,
    Test,  ///< the message is a `test` block on one line, which fails until the fault is mended
  };
  std::string message;
  std::optional<DiagnosticPlace> place;
  Kind kind = Kind::Remark;
  bool operator==(const DiagnosticNote&) const = default;
};

/// A change of a text that would mend a fault.
struct SuggestedEdit {
  DiagnosticPlace place;  ///< what is replaced; empty where something is put in
  std::string replacement;
  std::string what;  ///< a phrase: "'HH' becomes 'H'"
  bool operator==(const SuggestedEdit&) const = default;
};

/// One finding. Self-contained: it can be shown without the text that it is about.
struct Diagnostic {
  /// As severe as findings with this code are.
  explicit Diagnostic(Code what) : severity(infoOf(what).severity), code(what) {}

  Severity severity;
  Code code;
  std::string message;  ///< the fault, one line without a full stop
  DiagnosticPlace place;
  std::string label;  ///< a few words beside the caret; may be empty
  std::vector<DiagnosticNote> notes;
  std::string help;                  ///< the way out; may be empty
  std::vector<SuggestedEdit> edits;  ///< ways to take it at once, the likeliest first
  std::string rule;                  ///< the title of the rule it is about; may be empty
  bool isUnused = false;  ///< nothing uses what stands at the place; editors show it faded
  bool operator==(const Diagnostic&) const = default;
};

AF2_EXPORT DiagnosticPlace placeOf(const SourceText& source, Span span);

AF2_EXPORT bool hasErrors(std::span<const Diagnostic> diagnostics);

/// Collects findings: the same thing is told once, files in the order in which they were first
/// seen, places in the order of the text.
class AF2_EXPORT DiagnosticList {
 public:
  /// At most so many are shown; some more are kept, since they are not found in the order of the
  /// text.
  static constexpr std::size_t kMost = 50;
  static constexpr std::size_t kKept = 4 * kMost;

  /// Whether another finding would be kept. An error that is not counts all the same.
  bool takes(Severity severity);
  bool isFull() const { return found_.size() >= kKept; }
  void add(Diagnostic diagnostic);
  void append(DiagnosticList others);
  bool hasErrors() const { return hasErrors_; }
  std::size_t size() const { return found_.size(); }
  /// Sorted; if there were more than kMost, a last one says how many were left out.
  std::vector<Diagnostic> take();

 private:
  std::vector<Diagnostic> found_;
  bool hasErrors_ = false;
};

enum class Colour { None, Terminal };

/// The forms in which findings can be written.
AF2_EXPORT std::string toPretty(const Diagnostic& diagnostic, Colour colour = Colour::None);
AF2_EXPORT std::string toPretty(std::span<const Diagnostic> diagnostics,
                                Colour colour = Colour::None);
AF2_EXPORT std::string toGcc(std::span<const Diagnostic> diagnostics);
/// A list of {file, line, column, end_line, end_column, severity, code, message, notes, help}.
AF2_EXPORT std::string toJson(std::span<const Diagnostic> diagnostics);
/// SARIF 2.1.0, as code hosts take it.
AF2_EXPORT std::string toSarif(std::span<const Diagnostic> diagnostics);

}  // namespace af2::dsl
