// af2 test
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/program/colour.h"
#include "cli/program/exit_code.h"
#include "cli/program/usage_error.h"
#include "cli/program/verbs.h"
#include "cli/rules/plugins.h"
#include "cli/rules/rule_files.h"
#include "cli/rules/test_coverage.h"
#include "dsl/load/loaded_file.h"
#include "dsl/run/rule_tests.h"

namespace af2::cli {
namespace {

struct TestOptions {
  std::vector<std::string> files, plugins;
  std::string filter, format = "pretty";
  bool coverage = false, bench = false, quiet = false;
};

struct Totals {
  std::size_t passed = 0, failed = 0, broken = 0;  ///< broken: files that cannot be read
};

nlohmann::ordered_json jsonOf(const dsl::TestResult& result) {
  auto failures = nlohmann::ordered_json::array();
  for (const dsl::TestFailure& failure : result.failures) {
    failures.push_back(
        {{"line", failure.place.line}, {"expected", failure.expected}, {"got", failure.got}});
  }
  nlohmann::ordered_json json{{"file", result.place.file},
                              {"line", result.place.line},
                              {"title", result.title},
                              {"passed", result.passed()}};
  if (result.isProperty) {
    json["samples"] = result.samples;
  } else {
    json["rule"] = result.appliedRule;
    json["score"] = result.score;
  }
  json["failures"] = std::move(failures);
  if (!result.explanation.empty()) json["explanation"] = result.explanation;
  return json;
}

/// Prints the microseconds that one step takes on the front of each test.
void printTimes(const dsl::LoadedRules& loaded) {
  using Clock = std::chrono::steady_clock;
  SingleStepper stepper(*loaded.rules);
  constexpr auto kLongEnough = std::chrono::milliseconds(20);
  for (const dsl::CompiledTest& test : loaded.file->tests) {
    std::size_t steps = 0;
    const auto begin = Clock::now();
    while (Clock::now() - begin < kLongEnough) {
      stepper.take(test.piece);
      ++steps;
    }
    const std::chrono::duration<double, std::micro> spent = Clock::now() - begin;
    fmt::print("{:9.2f} us  {}\n", spent.count() / static_cast<double>(steps), test.title);
  }
}

class TestRun {
 public:
  explicit TestRun(const TestOptions& options) : options_(options) {}

  void file(const std::string& name) {
    const dsl::LoadedRules loaded = loadRuleFile(name, {options_.plugins});
    if (!loaded.rules) {
      if (dsl::hasErrors(loaded.diagnostics)) {
        fmt::print(stderr, "{}", dsl::toPretty(loaded.diagnostics, colourOf(stderr)));
        ++totals_.broken;
      } else if (!loaded.file->tests.empty()) {
        fmt::print(stderr, "{}: the file has tests but no rule\n", name);
        ++totals_.broken;
      }
      return;
    }
    for (const dsl::TestResult& result : dsl::runRuleTests(loaded, options_.filter)) add(result);
    if (options_.coverage) addCoverage(name, testCoverage(loaded));
    if (options_.bench && isPretty()) printTimes(loaded);
  }

  /// Whether there was no test at all, not even one that an error prevented from running.
  bool isEmpty() const { return totals_.passed + totals_.failed + totals_.broken == 0; }

  int finish() const {
    if (isPretty()) {
      fmt::print("{} passed, {} failed", totals_.passed, totals_.failed);
      if (totals_.broken > 0) fmt::print(", {} not run because of errors", totals_.broken);
      fmt::print("\n");
    } else {
      nlohmann::ordered_json whole = json_;
      if (options_.coverage) whole = {{"tests", json_}, {"coverage", coverage_}};
      fmt::print("{}\n", whole.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    }
    return totals_.failed + totals_.broken > 0 ? kUnusable : kComplete;
  }

 private:
  bool isPretty() const { return options_.format == "pretty"; }

  void add(const dsl::TestResult& result) {
    ++(result.passed() ? totals_.passed : totals_.failed);
    json_.push_back(jsonOf(result));
    if (isPretty() && !(options_.quiet && result.passed())) fmt::print("{}", toText(result));
  }

  void addCoverage(const std::string& file, const std::vector<RuleCoverage>& coverage) {
    if (isPretty())
      fmt::print("{}", toText(coverage));
    else
      coverage_.push_back(toJson(file, coverage));
  }

  const TestOptions& options_;
  Totals totals_;
  nlohmann::ordered_json coverage_ = nlohmann::ordered_json::array();
  nlohmann::ordered_json json_ = nlohmann::ordered_json::array();
};

int test(const TestOptions& options) {
  TestRun run(options);
  for (const std::string& file : expandRuleFiles(options.files)) run.file(file);
  if (!options.filter.empty() && run.isEmpty())
    throw UsageError(fmt::format("--filter '{}': no title of a test contains it", options.filter));
  return run.finish();
}

}  // namespace

Action declareTest(CLI::App& command) {
  const auto options = std::make_shared<TestOptions>();
  command
      .add_option("FILES", options->files, "rule files, folders with rule files, or - for stdin")
      ->type_name("")
      ->required();
  command
      .add_option("-k,--filter", options->filter, "run only tests whose title contains this text")
      ->type_name("TEXT");
  command.add_option("--format", options->format, "pretty or json")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"pretty", "json"}).description(""));
  command.add_flag("--coverage", options->coverage,
                   "report which clauses of the rules the tests exercise");
  command.add_flag("--bench", options->bench,
                   "measure the time of one step on the front of each test");
  command.add_flag("-q,--quiet", options->quiet, "print only tests that fail");
  addPluginOption(command, options->plugins);
  return [options] { return test(*options); };
}

}  // namespace af2::cli
