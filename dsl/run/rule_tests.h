// Runs the tests that stand in rule files.
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
  std::size_t samples = 0;  ///< of a property: matches looked at
  bool passed() const { return failures.empty(); }
};

/// One test. `rules` must be without errors, and `stepper` one for its rule set.
AF2_EXPORT TestResult runTest(const LoadedRules& rules, SingleStepper& stepper,
                              const CompiledTest& test);

/// One property, on matches spread over what its rule accepts; the same ones each time.
AF2_EXPORT TestResult runProperty(const LoadedRules& rules, const CompiledProperty& property);

/// All tests and properties whose titles hold `filter`, in file order.
AF2_EXPORT std::vector<TestResult> runRuleTests(const LoadedRules& rules,
                                                const std::string& filter = {});

/// "ok    title" or "FAIL  title   file:line" with what was expected and what came.
AF2_EXPORT std::string toText(const TestResult& result);

}  // namespace af2::dsl
