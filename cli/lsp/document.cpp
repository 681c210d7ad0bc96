#include "cli/lsp/document.h"

#include <algorithm>

#include "cli/lsp/uri.h"

namespace af2::lsp {
namespace {

std::vector<std::string> filesOf(const dsl::LoadedRules& rules) {
  std::vector<std::string> files;
  for (const auto& module : rules.file->modules) files.push_back(canonical(module->source.name()));
  return files;
}

}  // namespace

Analysis::Analysis(dsl::LoadedRules rules)
    : loaded(std::move(rules)), symbols(loaded.file->modules), files(filesOf(loaded)) {
  misses = std::ranges::any_of(loaded.diagnostics, [](const dsl::Diagnostic& d) {
    return d.code == dsl::Code::UnreadableFile;
  });
}

std::vector<const dsl::CompiledRule*> Analysis::rulesOf(const dsl::Symbol& rule) const {
  std::vector<const dsl::CompiledRule*> found;
  for (const dsl::CompiledRule& r : loaded.file->rules) {
    const std::string& title = r.definition.name;
    const bool isHere = r.home == rule.home || rule.home == &main();
    if (isHere && (title == rule.name || dsl::isTitleOf(rule.name, title))) found.push_back(&r);
  }
  return found;
}

void Document::apply(const Json& change, Encoding encoding) {
  auto replacement = change.at("text").get<std::string>();
  if (change.contains("range")) {
    const dsl::Span span = TextMap(text, encoding).span(change["range"]);
    text.replace(span.begin, span.end - span.begin, replacement);
  } else {
    text = std::move(replacement);
  }
  testFailures.clear();
  analysis.reset();
  isChanged = true;
}

}  // namespace af2::lsp
