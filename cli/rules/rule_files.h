// Rule files as the command line names them.
#pragma once

#include <string>
#include <vector>

#include "dsl/load/fixes.h"
#include "dsl/load/rule_file.h"

namespace af2::cli {

/// A text and what diagnostics call it.
struct RuleText {
  std::string name, text;
};

/// Directories become the .af2 files below them, in order of path; other names stay, among them "-"
/// for standard input. Throws UsageError if a directory has no rule file.
std::vector<std::string> expandRuleFiles(const std::vector<std::string>& names);

/// The text of a file or of standard input. Throws InputError if it cannot be read.
RuleText readRuleText(const std::string& name);

/// Loads a file, named by its path or within the rules of AF2, or standard input. That there is no
/// such file is a diagnostic; that there is no rule set is none, since files that others import
/// have none.
dsl::LoadedRules loadRuleFile(const std::string& name, const std::vector<dsl::Code>& allowed = {});

/// A rule text with what has one obvious remedy mended.
dsl::FixedText fixRuleText(const RuleText& input);

/// The same for verbs that look at rules: if there is an error, prints what is wrong to stderr and
/// throws InputError; also if there is no rule. Warnings are left to `af2 check`.
dsl::LoadedRules loadSoundRuleFile(const std::string& name);

/// The stem of a file name, for the files that are made from it; "rules" for standard input.
std::string stemOf(const std::string& name);

}  // namespace af2::cli
