// What all steps from syntax trees to rules share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dsl/compile/module.h"
#include "dsl/program/registry.h"
#include "dsl/text/diagnostic.h"
#include "dsl/text/help.h"

namespace af2::dsl {

/// Shared by all that is compiled in one run.
struct CompileContext {
  DiagnosticList& diagnostics;
  const Registry& registry;
  std::size_t stepsLeft = 2'000'000;  ///< defs that call each other can grow without bound
  std::size_t rulesLeft = 5'000;      ///< so can families, and files that use each other
  bool guesses = true;                ///< whether anybody will read what is told

  /// Whether to look for what was meant by a name that there is not: it takes its time for each.
  bool mayGuess() const { return guesses && !diagnostics.isFull(); }

  /// Tells something about a stretch of a module, as severe as its code is unless it is said here.
  void tell(const Module& home, Code code, Span span, std::string message, Help help = {},
            std::vector<DiagnosticNote> notes = {}, std::optional<Severity> severity = {});
};

}  // namespace af2::dsl
