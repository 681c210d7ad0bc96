// The table of static checks: what is held against every rule set before it runs.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "dsl/compile/compiled_rule.h"
#include "dsl/text/diagnostic.h"
#include "engine/rule/rule_set.h"

namespace af2::dsl {

/// What checks look at: compiled rules, before the engine has seen them.
struct CheckedRules {
  std::span<const CompiledRule> rules;
  const RuleSetDefinition& settings;  ///< without rules
  const Module& main;
};

/// Takes findings about one rule.
class Findings {
 public:
  explicit Findings(DiagnosticList& diagnostics) : diagnostics_(diagnostics) {}
  void add(const CompiledRule& rule, Code code, Span span, std::string message,
           std::string label = {}, std::string help = {}, std::vector<DiagnosticNote> notes = {},
           std::vector<SuggestedEdit> edits = {});
  /// Titles of the rules with errors. A mirror image has those of its rule, which are told once.
  const std::set<std::string>& faulty() const { return faulty_; }

 private:
  DiagnosticList& diagnostics_;
  std::set<std::string> faulty_;
};

/// One check. Give it a file of its own, a row and a declaration in checks.cpp, a code in
/// dsl/text/diagnostic_codes.def, and cases in tests/dsl/codes.
struct Check {
  int stage = 0;  ///< rules in which one stage finds errors are not shown to later ones
  std::array<std::optional<Code>, 3> codes;  ///< of what it finds
  std::string_view question;
  void (*run)(const CheckedRules& rules, Findings& findings);
  bool standsAlone = false;  ///< what other checks found makes no difference to it
};

std::span<const Check> checks();

/// Runs all checks. Of one place only the first error is told. Returns the rules without errors.
std::vector<CompiledRule> runChecks(const CheckedRules& rules, DiagnosticList& diagnostics);

// ---- what several checks ask --------------------------------------------------------------------

/// Name of a vertex of a rule.
std::string vertexName(const CompiledRule& rule, int vertex);

/// The first level at which the rule's conditions let anything through, and the later ones at which
/// a vertex is expected somewhere else than at the level before.
std::vector<int> referenceLevels(const RuleDefinition& rule);

/// Positions of all vertices at the reference match; nothing if a new vertex has none there.
std::optional<std::vector<Point2>> referencePositions(const CompiledRule& rule, int level);

/// A vertex that lies below the base edge at the reference match, as words; empty if none does.
std::string belowBase(const CompiledRule& rule, int level);

/// "the reference match", with its level where there are several.
std::string referenceName(const CompiledRule& rule, int level);

}  // namespace af2::dsl
