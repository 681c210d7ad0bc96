// A rule file as the editor shows it, and what is known of it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/lsp/text_map.h"
#include "dsl/load/loaded_file.h"
#include "dsl/load/rule_file.h"
#include "dsl/symbols/symbol_index.h"

namespace af2::lsp {

/// Everything that follows from one version of a text. Immutable; the checks in the background read
/// it while the text goes on changing.
struct Analysis {
  explicit Analysis(dsl::LoadedRules rules);

  dsl::LoadedRules loaded;
  dsl::SymbolIndex symbols;
  std::vector<std::string> files;  ///< canonical paths of the file itself and of what it imports
  bool misses = false;             ///< an import was not found; it may turn up

  const dsl::Module& main() const { return loaded.file->main(); }
  /// The rule set; while something is wrong with the file, what is sound of it. May be null.
  std::shared_ptr<const RuleSet> soundRules() const { return loaded.file->soundRules; }
  /// The compiled rules that stand in an item of the file, mirror images included.
  std::vector<const dsl::CompiledRule*> rulesOf(const dsl::Symbol& rule) const;
};

struct Document {
  std::string uri, path, text;
  std::optional<int> version;      ///< nothing: not open, read from the disk
  bool isChanged = false;          ///< since its diagnostics were last sent
  std::vector<Json> testFailures;  ///< diagnostics of the last test run, until the text changes
  std::shared_ptr<const Analysis> analysis;  ///< null: to be made when somebody asks
  std::shared_ptr<const Analysis> checking;  ///< the one that slow checks were started for
  std::vector<dsl::Diagnostic> checked;      ///< what they have found in it so far

  /// Applies one change of textDocument/didChange: `{text}`, or `{range, text}`.
  void apply(const Json& change, Encoding encoding);
};

}  // namespace af2::lsp
