#include "dsl/symbols/symbol_index.h"

#include <algorithm>

namespace af2::dsl {

const char* wordFor(SymbolKind kind) {
  switch (kind) {
    case SymbolKind::Vertex:
      return "vertex";
    case SymbolKind::NewVertex:
      return "new vertex";
    case SymbolKind::Let:
      return "let";
    case SymbolKind::Parameter:
      return "parameter";
    case SymbolKind::TestVertex:
      return "vertex of the test";
    case SymbolKind::Constant:
      return "const";
    case SymbolKind::Function:
      return "def";
    case SymbolKind::Metric:
      return "metric";
    case SymbolKind::Template:
      return "template";
    case SymbolKind::Rule:
      return "rule";
    case SymbolKind::RuleSet:
      return "rule set";
    case SymbolKind::Test:
      return "test";
    case SymbolKind::Property:
      return "property";
    case SymbolKind::Import:
      return "import";
  }
  return "name";
}

std::span<const Occurrence> SymbolIndex::occurrencesIn(const Module& module) const {
  const auto found = occurrences_.find(&module);
  return found == occurrences_.end() ? std::span<const Occurrence>() : found->second;
}

std::optional<Occurrence> SymbolIndex::at(const Module& module, std::uint32_t offset) const {
  std::optional<Occurrence> best;
  for (const Occurrence& o : occurrencesIn(module)) {
    if (o.span.begin > offset) break;
    if (o.span.end < offset) continue;
    // Of two adjacent occurrences, takes the one that begins here; of nested ones, the inner one.
    if (!best || o.span.begin >= best->span.begin) best = o;
  }
  return best;
}

std::vector<std::size_t> SymbolIndex::visibleAt(const Module& module, std::uint32_t offset) const {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < symbols_.size(); ++i) {
    const Symbol& s = symbols_[i];
    if (s.home == &module && s.scope.begin <= offset && offset <= s.scope.end) result.push_back(i);
  }
  const auto size = [&](std::size_t i) { return symbols_[i].scope.end - symbols_[i].scope.begin; };
  std::ranges::stable_sort(result, {}, size);
  return result;
}

std::vector<std::size_t> SymbolIndex::testsOf(std::size_t rule) const {
  const auto found = testsOf_.find(rule);
  return found == testsOf_.end() ? std::vector<std::size_t>() : found->second;
}

}  // namespace af2::dsl
