// What the page shows of the rules and tests of a text.
#pragma once

#include <memory>
#include <stop_token>

#include "cli/lsp/document.h"

namespace af2::playground {

/// {rules: [{title, line, isMirror, levels, elements, svg}], more, fault}: the sound rules with
/// their pictures. Of large sets only the first ones are drawn; `more` counts the others. `fault`
/// says why there is no rule. `line` is 0 for a rule of another file.
lsp::Json rulesPreview(const lsp::Analysis& analysis, const std::stop_token& stop);

/// {tests: [{title, line, passed, isProperty, rule, failures: [{line, expected, got}],
/// explanation}], fault}: the results of the tests and properties; `fault` says why they were not
/// run, or that the time was over before all of them were.
lsp::Json testsPreview(const lsp::Analysis& analysis, const std::stop_token& stop);

}  // namespace af2::playground
