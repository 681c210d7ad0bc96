// An index of the names in rule files: their definitions, uses and scopes.
#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "dsl/compile/module.h"
#include "dsl/syntax/titles.h"

namespace af2::dsl {

enum class SymbolKind {
  Vertex,      ///< a matched vertex of a rule
  NewVertex,   ///< of `new`
  Let,         ///< of `let`
  Parameter,   ///< of a def, a metric, a template, a family; the variable of a property
  TestVertex,  ///< a vertex of a test
  Constant,
  Function,  ///< a `def`
  Metric,
  Template,
  Rule,  ///< also: an instance of a template, the mirror image of a rule
  RuleSet,
  Test,
  Property,
  Import,  ///< the name by which an imported file is known
};

inline constexpr std::size_t kNoSymbol = std::numeric_limits<std::size_t>::max();

struct Symbol {
  SymbolKind kind = SymbolKind::Let;
  std::string name;  ///< titles are without quotes; titles of families include their {k}
  const Module* home = nullptr;  ///< the file in which it is defined
  Span definition;  ///< the name, or the title with its quotes; empty if it is not in the text
  Span whole;       ///< the whole definition, for display
  Span scope;       ///< where its name is valid
  std::size_t owner = kNoSymbol;   ///< the rule, test, ... that contains it
  std::string doc;                 ///< its doc comment
  const Item* item = nullptr;      ///< the item of the file that contains it
  const Module* target = nullptr;  ///< for an import: the file; null if it cannot be read
  bool isMirror = false;           ///< for a rule: whether a `mirror` clause makes it

  /// Titles are written in quotes.
  bool isTitle() const {
    return kind == SymbolKind::Rule || kind == SymbolKind::RuleSet || kind == SymbolKind::Test ||
           kind == SymbolKind::Property;
  }
  /// Whether the symbol is valid in the whole file. Except for tests, properties and imports, it is
  /// then also valid in files that import this file.
  bool isGlobal() const { return owner == kNoSymbol; }
};

/// An occurrence of the name of a symbol in the text.
struct Occurrence {
  Span span;
  std::size_t symbol = kNoSymbol;
  bool isDefinition = false;
};

/// The name of a kind for users: "rule", "let", "new vertex", ...
const char* wordFor(SymbolKind kind);

/// All names of a file and its imports. Broken clauses are missing; all other clauses are included.
class SymbolIndex {
 public:
  /// modules[0] is the file itself. They must outlive the index.
  explicit SymbolIndex(std::span<const std::unique_ptr<Module>> modules);

  const std::vector<Symbol>& symbols() const { return symbols_; }
  const Symbol& operator[](std::size_t symbol) const { return symbols_[symbol]; }

  /// In the order of the text.
  std::span<const Occurrence> occurrencesIn(const Module& module) const;
  /// The occurrence that contains `offset` or ends there.
  std::optional<Occurrence> at(const Module& module, std::uint32_t offset) const;
  /// Names that are valid at `offset`, those of the innermost block first.
  std::vector<std::size_t> visibleAt(const Module& module, std::uint32_t offset) const;
  /// Tests and properties that mention the rule.
  std::vector<std::size_t> testsOf(std::size_t rule) const;

 private:
  friend class SymbolIndexBuilder;
  std::vector<Symbol> symbols_;
  std::map<const Module*, std::vector<Occurrence>> occurrences_;
  std::map<std::size_t, std::vector<std::size_t>> testsOf_;
};

}  // namespace af2::dsl
