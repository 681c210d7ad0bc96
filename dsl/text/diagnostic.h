// Diagnostics of rule files: each has a place, a fault and a way out.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dsl/text/diagnostic_codes.h"
#include "dsl/text/source_text.h"
#include "engine/base/export.h"

namespace af2::dsl {

/// A place in a file. It stays valid without the text of the file.
struct DiagnosticPlace {
  std::string file;
  int line = 0, column = 0, endLine = 0,
      endColumn = 0;   ///< from 1; the end is exclusive; 0: no place
  std::string text;    ///< the line; if it is very long, the part around the place
  int textColumn = 1;  ///< where in the line `text` begins
  bool operator==(const DiagnosticPlace&) const = default;
};

/// A further remark, perhaps about another place.
struct DiagnosticNote {
  enum class Kind {
    Remark,
    Test,  ///< the message is a `test` block on one line, which fails until the fault is corrected
  };
  std::string message;
  std::optional<DiagnosticPlace> place;
  Kind kind = Kind::Remark;
  bool operator==(const DiagnosticNote&) const = default;
};

/// A change of the text that corrects a fault.
struct SuggestedEdit {
  DiagnosticPlace place;  ///< the text to replace; empty for an insertion
  std::string replacement;
  std::string what;  ///< a phrase: "'HH' becomes 'H'"
  bool operator==(const SuggestedEdit&) const = default;
};

/// One finding. It is self-contained: it can be shown without the text of the file.
struct Diagnostic {
  /// The severity is the usual one of the code.
  explicit Diagnostic(Code what) : severity(infoOf(what).severity), code(what) {}

  Severity severity;
  Code code;
  std::string message;  ///< the fault, one line without a full stop
  DiagnosticPlace place;
  std::string label;  ///< a few words beside the caret; may be empty
  std::vector<DiagnosticNote> notes;
  std::string help;                  ///< the way out; may be empty
  std::vector<SuggestedEdit> edits;  ///< edits that carry out the help, the most likely first
  std::string rule;                  ///< the title of the rule it is about; may be empty
  bool isUnused = false;             ///< the text at the place is unused; editors show it faded
  bool operator==(const Diagnostic&) const = default;
};

AF2_EXPORT DiagnosticPlace placeOf(const SourceText& source, Span span);

AF2_EXPORT bool hasErrors(std::span<const Diagnostic> diagnostics);

/// Collects findings and sorts them: files in the order in which they were first seen, then places
/// in the order of the text. Findings with the same code at the same place are kept once.
class AF2_EXPORT DiagnosticList {
 public:
  /// kMax findings are shown. More are kept, because they are not found in the order of the text.
  static constexpr std::size_t kMax = 50;
  static constexpr std::size_t kKept = 4 * kMax;

  /// Whether another finding would be kept. hasErrors() also counts an error that is not kept.
  bool takes(Severity severity);
  bool isFull() const { return found_.size() >= kKept; }
  void add(Diagnostic diagnostic);
  void append(DiagnosticList others);
  bool hasErrors() const { return hasErrors_; }
  std::size_t size() const { return found_.size(); }
  /// The sorted findings. If there were more than kMax, a note on the last one gives the number
  /// that is not shown.
  std::vector<Diagnostic> take();

 private:
  std::vector<Diagnostic> found_;
  bool hasErrors_ = false;
};

enum class Colour { None, Terminal };

/// The output formats of findings.
AF2_EXPORT std::string toPretty(const Diagnostic& diagnostic, Colour colour = Colour::None);
AF2_EXPORT std::string toPretty(std::span<const Diagnostic> diagnostics,
                                Colour colour = Colour::None);
AF2_EXPORT std::string toGcc(std::span<const Diagnostic> diagnostics);
/// A list of {file, line, column, end_line, end_column, severity, code, message, notes, help}.
AF2_EXPORT std::string toJson(std::span<const Diagnostic> diagnostics);
/// SARIF 2.1.0, which code hosting sites accept.
AF2_EXPORT std::string toSarif(std::span<const Diagnostic> diagnostics);

}  // namespace af2::dsl
