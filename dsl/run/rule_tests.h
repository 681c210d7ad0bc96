// Runs the tests in rule files.
#pragma once

#include <string>
#include <vector>

#include "dsl/load/rule_file.h"
#include "engine/base/export.h"
#include "engine/step/single_step.h"

namespace af2::dsl {

struct CompiledTest;
struct CompiledProperty;

/// An expectation that was not met.
struct TestFailure {
  DiagnosticPlace place;  ///< of the `expect` clause
  std::string expected, got;
};

struct TestResult {
  std::string title;
  DiagnosticPlace place;
  std::vector<TestFailure> failures;
  std::string appliedRule;  ///< empty: none
  double score = 0;
  bool isProperty = false;
  std::string explanation;  ///< of each rule, if the test failed; lines of a table
  std::size_t samples = 0;  ///< for a property: the number of matches tried
  bool passed() const { return failures.empty(); }
};

/// Runs one test. `rules` must have no errors, and `stepper` must use its rule set.
AF2_EXPORT TestResult runTest(const LoadedRules& rules, SingleStepper& stepper,
                              const CompiledTest& test);

/// Runs one property on sampled matches of its rule. The samples are the same in every run.
AF2_EXPORT TestResult runProperty(const LoadedRules& rules, const CompiledProperty& property);

/// Runs all tests and properties whose titles contain `filter`, in the order of the file.
AF2_EXPORT std::vector<TestResult> runRuleTests(const LoadedRules& rules,
                                                const std::string& filter = {});

/// "ok title", or "FAIL title file:line" with the expectation and the result.
AF2_EXPORT std::string toText(const TestResult& result);

}  // namespace af2::dsl
