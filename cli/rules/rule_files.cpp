#include "cli/rules/rule_files.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "cli/program/colour.h"
#include "cli/program/usage_error.h"
#include "cli/rules/plugins.h"
#include "cli/rules/rules_location.h"
#include "dsl/compile/library.h"
#include "dsl/proof/match_diagnostics.h"
#include "engine/base/error.h"

namespace af2::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStandardInput = "-";

std::vector<std::string> ruleFilesBelow(const fs::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && entry.path().extension() == ".af2") {
      files.push_back(entry.path().string());
    }
  }
  std::ranges::sort(files);
  if (files.empty()) {
    throw UsageError(fmt::format("there is no .af2 file in the directory '{}'", folder.string()));
  }
  return files;
}

/// The path if there is such a file, else the file within the rules of AF2; else the name itself.
fs::path resolved(const std::string& name) {
  std::error_code ignored;
  if (fs::exists(name, ignored)) return name;
  try {
    return findRuleFile(name);
  } catch (const InputError&) {
    return name;
  }
}

dsl::LoadOptions optionsFor(const RuleReading& reading, const dsl::Registry& registry) {
  dsl::LoadOptions options;
  options.allowed = reading.allowed;
  options.externs = reading.externs;
  options.registry = &registry;
  options.needsRuleSet = false;
  try {
    options.searchPaths = {rulesDirectory()};
  } catch (const InputError&) {
    // A file without imports does not need the rules of AF2; for others the missing import is
    // reported.
  }
  return options;
}

}  // namespace

std::vector<std::string> expandRuleFiles(const std::vector<std::string>& names) {
  std::vector<std::string> files;
  for (const std::string& name : names) {
    std::error_code ignored;
    if (name != kStandardInput && fs::is_directory(name, ignored)) {
      std::ranges::move(ruleFilesBelow(name), std::back_inserter(files));
    } else {
      files.push_back(name);
    }
  }
  return files;
}

RuleText readRuleText(const std::string& name) {
  if (name == kStandardInput) return {"<stdin>", dsl::readRuleText(std::cin)};
  const fs::path path = resolved(name);
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    throw InputError(fmt::format("'{}' is a directory, not a rule file", name));
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(fmt::format("the rule file '{}' cannot be read", name));
  return {path.string(), dsl::readRuleText(file)};
}

dsl::LoadedRules loadRuleFile(const std::string& name, const RuleReading& reading) {
  const dsl::Registry registry = loadPlugins(reading.plugins);
  const dsl::LoadOptions options = optionsFor(reading, registry);
  if (name != kStandardInput) return dsl::loadRules(resolved(name), options);
  RuleText input = readRuleText(name);
  return dsl::loadRulesFromText(std::move(input.name), std::move(input.text), options);
}

dsl::LoadedRules loadRuleText(const RuleText& input, const RuleReading& reading) {
  const dsl::Registry registry = loadPlugins(reading.plugins);
  return dsl::loadRulesFromText(input.name, input.text, optionsFor(reading, registry));
}

dsl::FixedText fixRuleText(const RuleText& input, const RuleReading& reading) {
  const dsl::Registry registry = loadPlugins(reading.plugins);
  return dsl::fixText(input.name, input.text, optionsFor(reading, registry), dsl::dropIdleMirrors);
}

dsl::LoadedRules loadSoundRuleFile(const std::string& name, const RuleReading& reading) {
  dsl::LoadedRules loaded = loadRuleFile(name, reading);
  if (loaded.rules) return loaded;
  if (!dsl::hasErrors(loaded.diagnostics))
    throw InputError(fmt::format("there is no rule in the file '{}'", name));
  fmt::print(stderr, "{}", dsl::toPretty(loaded.diagnostics, colourOf(stderr)));
  throw InputError(fmt::format("the rule file '{}' has errors, see above", name));
}

std::string stemOf(const std::string& name) {
  return name == kStandardInput ? "rules" : fs::path(name).stem().string();
}

}  // namespace af2::cli
