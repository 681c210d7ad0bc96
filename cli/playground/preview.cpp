#include "cli/playground/preview.h"

#include <fmt/core.h>

#include "cli/lsp/rule_facts.h"
#include "dsl/picture/rule_picture.h"
#include "dsl/run/rule_tests.h"

namespace af2::playground {
namespace {

using lsp::Json;

constexpr std::size_t kMaxDrawn = 150;

/// Why there are no rules.
std::string faultOf(const lsp::Analysis& analysis) {
  for (const dsl::Diagnostic& d : analysis.loaded.diagnostics)
    if (d.severity == dsl::Severity::Error)
      return fmt::format("Line {}: {}", d.place.line, d.message);
  return "The file has no rules.";
}

std::string elementsText(const AF2Rule& rule) {
  const lsp::RuleFacts facts = lsp::factsOf(rule);
  std::string text;
  const auto add = [&](std::size_t count, const char* what) {
    if (count == 0) return;
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", count, what, count == 1 ? "" : "s");
  };
  add(facts.triangles, "triangle");
  add(facts.quads, "quad");
  return text;
}

std::string levelsText(const AF2Rule& rule) {
  const int first = rule.definition().firstLevel;
  return first == 1 ? "" : fmt::format("from level {}", first);
}

/// The compiled rules begin with the sound ones, in the same order.
Json ruleJson(const lsp::Analysis& analysis, const RuleSet& rules, std::size_t i) {
  const AF2Rule& rule = rules.rules()[i];
  const dsl::CompiledRule& compiled = analysis.loaded.file->rules[i];
  const bool isHere = compiled.home == &analysis.main();
  dsl::PictureOptions options;
  options.width = options.height = 260;
  return {{"title", rule.name()},
          {"line", isHere ? compiled.titlePlace.line : 0},
          {"isMirror", compiled.isMirror},
          {"levels", levelsText(rule)},
          {"elements", elementsText(rule)},
          {"svg", dsl::drawRule(rules, rule, dsl::PictureFormat::Svg, options)}};
}

Json testJson(const dsl::TestResult& result) {
  Json failures = Json::array();
  for (const dsl::TestFailure& failure : result.failures)
    failures.push_back(
        {{"line", failure.place.line}, {"expected", failure.expected}, {"got", failure.got}});
  return {{"title", result.title},
          {"line", result.place.line},
          {"passed", result.passed()},
          {"isProperty", result.isProperty},
          {"rule", result.appliedRule},
          {"failures", std::move(failures)},
          {"explanation", result.explanation}};
}

/// Stops between two tests: each of them is short.
Json runTests(const lsp::Analysis& analysis, const std::stop_token& stop) {
  Json tests = Json::array();
  SingleStepper stepper(*analysis.loaded.rules);
  for (const dsl::CompiledTest& test : analysis.loaded.file->tests) {
    if (stop.stop_requested()) break;
    tests.push_back(testJson(dsl::runTest(analysis.loaded, stepper, test)));
  }
  for (const dsl::CompiledProperty& property : analysis.loaded.file->properties) {
    if (stop.stop_requested()) break;
    tests.push_back(testJson(dsl::runProperty(analysis.loaded, property)));
  }
  return tests;
}

}  // namespace

Json rulesPreview(const lsp::Analysis& analysis, const std::stop_token& stop) {
  const auto rules = analysis.soundRules();
  Json list = Json::array();
  if (!rules || rules->rules().empty())
    return {{"rules", list}, {"more", 0}, {"fault", faultOf(analysis)}};
  const std::size_t count = rules->rules().size();
  while (list.size() < std::min(count, kMaxDrawn) && !stop.stop_requested())
    list.push_back(ruleJson(analysis, *rules, list.size()));
  const std::size_t more = count - list.size();
  return {{"rules", std::move(list)}, {"more", more}, {"fault", ""}};
}

Json testsPreview(const lsp::Analysis& analysis, const std::stop_token& stop) {
  std::string fault = dsl::missingText(*analysis.loaded.file);
  if (!analysis.loaded.rules) fault = faultOf(analysis);
  Json tests = Json::array();
  if (fault.empty()) {
    tests = runTests(analysis, stop);
    if (stop.stop_requested()) fault = "The time was over before all tests were run.";
  }
  return {{"tests", std::move(tests)}, {"fault", fault}};
}

}  // namespace af2::playground
