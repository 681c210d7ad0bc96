#include "dsl/compile/compile_context.h"

namespace af2::dsl {

Diagnostic missingImplementation(const MissingName& missing) {
  Diagnostic d(Code::MissingImplementation);
  d.message = "'" + missing.name + "' is declared here, but nothing implements it";
  d.place = placeOf(missing.home->source, missing.span);
  d.help = "load the library that registers it: --plugin FILE";
  return d;
}

void CompileContext::tell(const Module& home, Code code, Span span, std::string message, Help help,
                          std::vector<DiagnosticNote> notes, std::optional<Severity> severity) {
  Diagnostic d(code);
  d.severity = severity.value_or(d.severity);
  if (!diagnostics.takes(d.severity)) return;
  d.message = std::move(message);
  d.place = placeOf(home.source, span);
  setHelp(d, home.source, span, help);
  d.notes = std::move(notes);
  diagnostics.add(std::move(d));
}

}  // namespace af2::dsl
