#include "dsl/load/shipped_rules.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>

#include "dsl/load/rule_file.h"
#include "engine/base/error.h"

namespace af2::dsl {
namespace {

constexpr ShippedFile kFiles[] = {
#include "shipped_rules.inc"
};

/// No folder of the disk, so that a file there cannot take the place of an import.
constexpr const char* kFolder = "/rules of AF2";

std::optional<std::string> textAt(const std::filesystem::path& path) {
  const std::string name = path.lexically_normal().lexically_relative(kFolder).generic_string();
  const auto found = std::ranges::find(kFiles, name, &ShippedFile::name);
  if (found == std::end(kFiles)) return std::nullopt;
  return std::string(found->text);
}

std::string namesOfAll() {
  std::string names;
  for (const ShippedFile& file : kFiles) names.append(names.empty() ? "" : ", ").append(file.name);
  return names;
}

}  // namespace

std::span<const ShippedFile> shippedFiles() { return kFiles; }

std::shared_ptr<const RuleSet> shippedRules(std::string_view name) {
  const std::filesystem::path path = std::filesystem::path(kFolder) / name;
  const auto text = textAt(path);
  if (!text)
    throw InputError("AF2 comes with no rule file '" + std::string(name) +
                     "'; these are there: " + namesOfAll());
  LoadOptions options;
  options.unsaved = textAt;
  LoadedRules loaded = loadRulesFromText(path.string(), *text, options);
  if (!loaded.rules) throw InputError(toPretty(loaded.diagnostics));
  return std::move(loaded.rules);
}

std::shared_ptr<const RuleSet> defaultRules() { return shippedRules("tri/even.af2"); }

}  // namespace af2::dsl
