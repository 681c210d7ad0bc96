// af2 new
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/program/colour.h"
#include "cli/program/exit_code.h"
#include "cli/program/text_files.h"
#include "cli/program/usage_error.h"
#include "cli/program/verbs.h"
#include "cli/rules/rule_files.h"
#include "dsl/format/printer.h"
#include "engine/base/error.h"

namespace af2::cli {
namespace {

// Few enough rules to read at once, but enough to mesh a real part.
constexpr std::string_view kRuleSet = R"(af2 1;
# TITLE: a rule set for triangles to start from.
#
#   af2 check FILE      finds mistakes
#   af2 test FILE       runs the tests at the end
#   af2 draw FILE       draws the rules
#   af2 mesh MODEL --size 1 -r FILE -o mesh.vtu

const H = sqrt(3) / 2;  # height of the unit triangle

ruleset "TITLE" {
  elements tri;
  match    (0.2*q)^2;
  score    max of shape_size(10);
  accept   score < 2 + 0.5*q^2;
  front    by q;
}

## Nothing near: a new vertex where the ideal apex is, lower after each refusal.
rule "free" quality 1 {
  let  m = mid(a, b);
  new  c = m + (0, H * max(0.2, 1.1 - 0.1*q));
  zone a, b, m + (1, 0.7) => c, m + (0, 1.5) => c, m + (-1, 0.7) => c;
  tri  a b c;
}

## The next edge stands at about 60 degrees: one triangle fills the corner.
rule "right" quality 1 {
  front a -> b -> c;
  at    c (0.5, H);
  zone  a, b, c, lerp(b, mid(a, c), 1.5) => mid(a, c);
  tri   a b c;
  mirror "left";
}

## A vertex of the front stands where the apex should be.
rule "ahead" quality 1 {
  at   c (0.5, H);
  zone a, b, lerp(a, mid(b, c), 1.5) => mid(b, c), c, lerp(b, mid(a, c), 1.5) => mid(a, c);
  tri  a b c;
}

## The front is down to three edges.
rule "close" quality 1 {
  front a -> b -> c -> a;
  at    c (0.5, H);
  zone  a, b, c;
  tri   a b c;
}

test "a lonely edge gets the ideal apex" {
  front  p (0, 0) -> r (1, 0);
  expect rule "free";
  expect new 1 at (0.5, H);
}

test "but not where something is in the way" {
  front  p (0, 0) -> r (1, 0), u (-1, 1.2) -> v (2, 1.2);
  expect not rule "free" because zone hit by edge u -> v;
}

test "a corner of 60 degrees is filled" {
  front  p (0, 0) -> r (1, 0) -> s (0.5, 0.9);
  expect rule "right" with c = s;
  expect front p -> s;
}
)";

constexpr std::string_view kRule = R"(
## When does this rule help?
rule "TITLE" quality 1 {
  front a -> b -> c;
  at    c (1.5, 0.866);
  new   d = a + (c - b);
  zone  a, b, c, 2*d - b => d;
  tri   a b d, b c d;
  mirror "TITLE, on the left";
}

test "TITLE: it applies here" {
  front  p (0, 0) -> r (1, 0) -> s (1.5, 0.866);
  expect rule "TITLE" with c = s;
  expect new 1 at (0.5, 0.866);
}

test "TITLE: but not here" {
  front  p (0, 0) -> r (1, 0) -> s (1.5, 0.866), u (1, 1.2) -> v (0, 1.2);
  expect not rule "TITLE";
}
)";

struct NewOptions {
  std::string what, name, into, title;
  bool force = false;
};

void replaceAll(std::string& text, std::string_view word, std::string_view by) {
  for (std::size_t at = text.find(word); at != std::string::npos;
       at = text.find(word, at + by.size())) {
    text.replace(at, word.size(), by);
  }
}

/// The title with the escapes that it needs between quotes in a rule file.
std::string quoted(const std::string& title) {
  if (title.find_first_not_of(' ') == std::string::npos)
    throw UsageError("the title is empty; describe in a few words what the rules are for");
  std::string text;
  for (const char c : title) {
    if (static_cast<unsigned char>(c) < 0x20) throw UsageError("a title must be plain text");
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text;
}

void newRuleSet(const NewOptions& options) {
  const std::string title = options.title.empty() ? stemOf(options.name) : options.title;
  std::string text(kRuleSet);
  replaceAll(text, "FILE", options.name == "-" ? "FILE" : options.name);
  replaceAll(text, "TITLE", quoted(title));
  std::error_code ignored;
  if (!options.force && std::filesystem::exists(options.name, ignored)) {
    throw UsageError(fmt::format("'{}' exists; choose another name or use --force", options.name));
  }
  writeText(options.name, text);
  if (options.name == "-") return;
  fmt::print("wrote {}\ntry: af2 test {}\n", options.name, options.name);
}

/// Titles that the added text gives a second time: of rules, of mirror images, of tests. Those that
/// the file had twice already are not its fault.
std::vector<dsl::Diagnostic> titlesTakenBy(const RuleText& before, const std::string& added) {
  const auto lineCount = 1 + std::ranges::count(before.text, '\n');
  std::vector<dsl::Diagnostic> taken =
      loadRuleText({before.name, before.text + added}, {{}, dsl::Externs::Declared}).diagnostics;
  std::erase_if(taken, [&](const dsl::Diagnostic& d) {
    return d.code != dsl::Code::DuplicateName || d.place.line < lineCount ||
           d.place.file != before.name;
  });
  return taken;
}

void newRule(const NewOptions& options) {
  std::string text(kRule);
  replaceAll(text, "TITLE", quoted(options.name));
  if (options.into.empty()) return writeText("-", std::string_view(text).substr(1));
  std::error_code ignored;
  if (!std::filesystem::exists(options.into, ignored))  // or a rule file that comes with AF2
    throw UsageError(
        fmt::format("there is no file '{}'; `af2 new ruleset` creates one", options.into));
  const RuleText before = readRuleText(options.into);
  const dsl::Formatted read = dsl::format(before.name, before.text);
  if (dsl::hasErrors(read.diagnostics)) {
    fmt::print(stderr, "{}", dsl::toPretty(read.diagnostics.front(), colourOf(stderr)));
    throw InputError(
        fmt::format("'{}' cannot be read as a rule file; it was not changed", before.name));
  }
  const std::vector<dsl::Diagnostic> taken = titlesTakenBy(before, text);
  if (!taken.empty()) {
    fmt::print(stderr, "{}", dsl::toPretty(taken, colourOf(stderr)));
    throw InputError(fmt::format(
        "'{}' has these titles already; choose another title. The file is left as it was",
        before.name));
  }
  writeText(before.name, before.text + text);
  fmt::print("added rule \"{}\" and two tests to {}\n", options.name, before.name);
}

}  // namespace

Action declareNew(CLI::App& command) {
  const auto options = std::make_shared<NewOptions>();
  command.add_option("WHAT", options->what, "ruleset or rule")
      ->type_name("")
      ->required()
      ->check(CLI::IsMember({"ruleset", "rule"}).description(""));
  command.add_option("NAME", options->name, "for a rule set: its file; for a rule: its title")
      ->type_name("")
      ->required();
  command
      .add_option("--title", options->title,
                  "for a rule set: its title; default: the name of the file")
      ->type_name("TEXT");
  command
      .add_option("--into", options->into,
                  "for a rule: the file that it is added to; default: stdout")
      ->type_name("FILE");
  command.add_flag("--force", options->force, "overwrite an existing file");
  return [options]() -> int {
    const bool isRule = options->what == "rule";
    if (isRule && !options->title.empty()) throw UsageError("--title is for rule sets");
    if (!isRule && !options->into.empty()) throw UsageError("--into is for rules");
    isRule ? newRule(*options) : newRuleSet(*options);
    return kComplete;
  };
}

}  // namespace af2::cli
