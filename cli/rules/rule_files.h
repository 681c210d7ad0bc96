// Finds and reads the rule files that the command line names.
#pragma once

#include <string>
#include <vector>

#include "dsl/load/fixes.h"
#include "dsl/load/rule_file.h"

namespace af2::cli {

/// A text and its name in diagnostics.
struct RuleText {
  std::string name, text;
};

/// Replaces directories by the .af2 files below them, in order of path. Other names stay, including
/// "-" for standard input. Throws UsageError if a directory has no rule file.
std::vector<std::string> expandRuleFiles(const std::vector<std::string>& names);

/// The text of a file or of standard input. Throws InputError if it cannot be read.
RuleText readRuleText(const std::string& name);

/// How a rule file is read, besides its name.
struct RuleReading {
  std::vector<std::string> plugins;  ///< libraries that register names, see plugins.h
  dsl::Externs externs = dsl::Externs::Registered;
  std::vector<dsl::Code> allowed = {};  ///< codes of warnings that are not reported
};

/// Loads a file, named by its path or within the rules of AF2, or standard input. A missing file is
/// reported as a diagnostic; a missing rule set is not, because libraries have none.
dsl::LoadedRules loadRuleFile(const std::string& name, const RuleReading& reading = {});

/// Loads a text that may differ from its file.
dsl::LoadedRules loadRuleText(const RuleText& input, const RuleReading& reading = {});

/// Corrects the errors of a rule text that have one obvious correction.
dsl::FixedText fixRuleText(const RuleText& input, const RuleReading& reading);

/// The same for verbs that show rules: if there is an error or no rule, prints the error to stderr
/// and throws InputError. Leaves warnings to `af2 check`.
dsl::LoadedRules loadSoundRuleFile(const std::string& name, const RuleReading& reading = {});

/// The stem of a file name, for naming files derived from it; "rules" for standard input.
std::string stemOf(const std::string& name);

}  // namespace af2::cli
