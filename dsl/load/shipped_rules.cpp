#include "dsl/load/shipped_rules.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>

#include "dsl/load/loaded_file.h"
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

LoadedRules loadShippedRules(std::string_view name) {
  const std::filesystem::path path = std::filesystem::path(kFolder) / name;
  const auto text = textAt(path);
  if (!text)
    throw InputError("AF2 comes with no rule file '" + std::string(name) +
                     "'; these are there: " + namesOfAll());
  return loadRulesFromText(path.string(), *text, withShippedImports({}));
}

std::shared_ptr<const RuleSet> shippedRules(std::string_view name) {
  LoadedRules loaded = loadShippedRules(name);
  if (!loaded.rules) throw InputError(toPretty(loaded.diagnostics));
  return std::move(loaded.rules);
}

std::shared_ptr<const RuleSet> defaultRules() { return shippedRules("tri/even.af2"); }

LoadOptions withShippedImports(LoadOptions options) {
  options.searchPaths.emplace_back(kFolder);
  options.unsaved = [others = std::move(options.unsaved)](const std::filesystem::path& path) {
    auto text = others ? others(path) : std::nullopt;
    return text ? text : textAt(path);
  };
  return options;
}

bool isShipped(const LoadedRules& loaded) {
  return std::ranges::all_of(loaded.file->modules, [](const auto& module) {
    return std::ranges::count(kFiles, module->source.text(), &ShippedFile::text) > 0;
  });
}

std::vector<RuleSource> sourcesOf(const LoadedRules& loaded) {
  const std::string folder = std::string(kFolder) + "/";
  std::vector<RuleSource> sources;
  for (std::size_t i = 0; i < loaded.rules->rules().size(); ++i) {
    const CompiledRule& rule = loaded.file->rules[i];
    const SourceText& source = rule.home->source;
    const Span span = rule.text->span;
    const std::string& name = source.name();
    sources.push_back({name.starts_with(folder) ? name.substr(folder.size()) : name,
                       source.lineOf(span.begin),
                       std::string(source.text().substr(span.begin, span.end - span.begin))});
  }
  return sources;
}

}  // namespace af2::dsl
