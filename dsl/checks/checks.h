// The table of static checks, which every rule set must pass before it runs.
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

/// The input of checks: compiled rules, before they are passed to the engine.
struct CheckedRules {
  std::span<const CompiledRule> rules;
  const RuleSetDefinition& settings;  ///< without rules
  const Module& main;
  std::set<Code> allowed;                     ///< for all rules
  std::optional<DiagnosticPlace> acceptance;  ///< of the `accept` of the rule set
};

/// Collects findings about rules.
class Findings {
 public:
  explicit Findings(DiagnosticList& diagnostics) : diagnostics_(diagnostics) {}
  void add(const CompiledRule& rule, Code code, Span span, std::string message,
           std::string label = {}, std::string help = {}, std::vector<DiagnosticNote> notes = {},
           std::vector<SuggestedEdit> edits = {});
  /// Titles of the rules with errors. The errors of a mirror image are those of its rule, and are
  /// reported once.
  const std::set<std::string>& faulty() const { return faulty_; }

 private:
  DiagnosticList& diagnostics_;
  std::set<std::string> faulty_;
};

/// One check. A new check needs its own file, a row and a declaration in checks.cpp, a code in
/// dsl/text/diagnostic_codes.def, and cases in tests/dsl/codes.
struct Check {
  int stage = 0;  ///< if a stage finds errors in a rule, later stages skip the rule
  std::array<std::optional<Code>, 3> codes;  ///< the codes of its findings
  std::string_view question;
  void (*run)(const CheckedRules& rules, Findings& findings);
  bool standsAlone = false;  ///< whether it also runs on rules with errors from other checks
  bool evaluates = false;    ///< whether it skips rules with names that nothing implements
};

std::span<const Check> checks();

/// Runs all checks. Only the first error at each place is reported. Returns the rules without
/// errors.
std::vector<CompiledRule> runChecks(const CheckedRules& rules, DiagnosticList& diagnostics);

// ---- functions that several checks use ----------------------------------------------------------

/// Name of a vertex of a rule.
std::string vertexName(const CompiledRule& rule, int vertex);

/// The first level at which the conditions of the rule accept anything, and the later levels at
/// which the reference position of a vertex differs from that of the level before.
std::vector<int> referenceLevels(const RuleDefinition& rule);

/// Positions of all vertices at the reference match; nothing if a new vertex has no position there.
std::optional<std::vector<Point2>> referencePositions(const CompiledRule& rule, int level);

/// A phrase that names a vertex below the base edge at the reference match; empty if there is none.
std::string belowBase(const CompiledRule& rule, int level);

/// "the reference match", with its level if there are several.
std::string referenceName(const CompiledRule& rule, int level);

}  // namespace af2::dsl
