#include "cli/rules/test_picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <variant>

#include "cli/program/usage_error.h"
#include "dsl/load/loaded_file.h"
#include "dsl/run/rule_tests.h"
#include "dsl/text/words.h"

namespace af2::cli {
namespace {

const dsl::CompiledTest& findTest(const dsl::LoadedFile& file, const std::string& title) {
  std::vector<std::string> titles;
  for (const dsl::CompiledTest& test : file.tests) {
    if (test.title == title) return test;
    titles.push_back(test.title);
  }
  if (std::ranges::count(file.properties, title, &dsl::CompiledProperty::title) > 0)
    throw UsageError(fmt::format(
        "--test \"{}\" is a property, which has no front; --rule draws its rule", title));
  if (titles.empty()) throw UsageError(fmt::format("--test \"{}\": the file has no tests", title));
  const std::string help = dsl::helpAmong(title, titles, "its tests are").text();
  throw UsageError(fmt::format("--test \"{}\": the file has no such test{}", title,
                               help.empty() ? "; 'af2 test FILE' lists them" : "; " + help));
}

/// The rule that the test is about, if another one or none was applied.
std::string expectedRule(const dsl::CompiledTest& test, const std::string& applied) {
  for (const dsl::CompiledExpectation& expectation : test.expectations) {
    const auto* isRule = std::get_if<dsl::CompiledExpectation::IsRule>(&expectation.outcome);
    if (isRule && isRule->title != applied) return isRule->title;
  }
  return {};
}

std::vector<std::string> outcomeLines(const dsl::TestResult& result, const FrontPiece& piece) {
  const std::string where = fmt::format("level {}, size {:g}", piece.level, piece.size);
  if (result.passed()) return {fmt::format("The test passes ({}).", where)};
  std::vector<std::string> lines{fmt::format("The test fails ({}).", where)};
  for (const dsl::TestFailure& failure : result.failures)
    lines.push_back(fmt::format("Line {} expects {}; got {}.", failure.place.line, failure.expected,
                                failure.got));
  return lines;
}

}  // namespace

std::string drawTest(const dsl::LoadedRules& rules, const std::string& title,
                     dsl::PictureFormat format, const dsl::PiecePictureOptions& options) {
  const dsl::CompiledTest& test = findTest(*rules.file, title);
  SingleStepper stepper(*rules.rules);
  const dsl::TestResult result = runTest(rules, stepper, test);
  const dsl::StepExplanation explained =
      dsl::explainStep(*rules.rules, stepper, test.piece, test.vertexNames, true);
  const dsl::PieceCaption caption{title, outcomeLines(result, test.piece),
                                  expectedRule(test, result.appliedRule)};
  return dsl::drawPiece(*rules.rules, test.piece, test.vertexNames, explained, caption, format,
                        options);
}

}  // namespace af2::cli
