// af2 explain-code
#include <fmt/core.h>

#include <memory>
#include <string>

#include "cli/program/exit_code.h"
#include "cli/program/usage_error.h"
#include "cli/program/verbs.h"
#include "dsl/text/diagnostic_codes.h"

namespace af2::cli {
namespace {

void listCodes() {
  for (const dsl::CodeInfo& info : dsl::diagnosticCodes()) {
    fmt::print("{:<4} {}\n", info.id, info.title);
  }
}

void explain(const std::string& name) {
  const auto code = dsl::findCode(name);
  if (!code) {
    throw UsageError(fmt::format(
        "there is no code '{}'; `af2 explain-code` without a code lists all codes", name));
  }
  const dsl::CodeInfo& info = dsl::infoOf(*code);
  fmt::print("{}: {}\n\n{}\n", dsl::fullIdOf(*code), info.title, info.explanation);
}

}  // namespace

Action declareExplainCode(CLI::App& command) {
  const auto name = std::make_shared<std::string>();
  command
      .add_option("CODE", *name,
                  "code of a diagnostic, such as A1 or AF2-A1; without it, all codes are listed")
      ->type_name("");
  return [name] {
    name->empty() ? listCodes() : explain(*name);
    return kComplete;
  };
}

}  // namespace af2::cli
