#include "dsl/compile/compile_context.h"

namespace af2::dsl {

void CompileContext::tell(const Module& home, const char* code, Span span, std::string message,
                          Help help, std::vector<DiagnosticNote> notes, Severity severity) {
  if (!diagnostics.takes(severity)) return;
  Diagnostic d;
  d.severity = severity;
  d.code = code;
  d.message = std::move(message);
  d.place = placeOf(home.source, span);
  setHelp(d, home.source, span, help);
  d.notes = std::move(notes);
  diagnostics.add(std::move(d));
}

}  // namespace af2::dsl
