// State that all steps of the compilation share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dsl/compile/module.h"
#include "dsl/program/registry.h"
#include "dsl/text/diagnostic.h"
#include "dsl/text/help.h"

namespace af2::dsl {

/// A declared name without an implementation.
struct MissingName {
  std::string name;
  const Module* home = nullptr;
  Span span;  ///< of the name in its declaration
  bool operator==(const MissingName&) const = default;
};

/// R6 at the declaration.
Diagnostic missingImplementation(const MissingName& missing);

/// Shared by everything that is compiled in one run.
struct CompileContext {
  DiagnosticList& diagnostics;
  const Registry& registry;
  std::size_t stepsLeft = 2'000'000;  ///< defs that call other defs can unfold without bound
  std::size_t rulesLeft =
      5'000;            ///< families and imported files can multiply rules in the same way
  bool guesses = true;  ///< whether anybody will read the diagnostics

  std::vector<MissingName> missing = {};  ///< those that were used since the list was taken

  /// Whether to search for the name that an unknown name was meant to be. Each search takes time.
  bool mayGuess() const { return guesses && !diagnostics.isFull(); }

  /// Reports a finding about a span of a module. Its severity is that of its code unless given
  /// here.
  void tell(const Module& home, Code code, Span span, std::string message, Help help = {},
            std::vector<DiagnosticNote> notes = {}, std::optional<Severity> severity = {});
};

}  // namespace af2::dsl
