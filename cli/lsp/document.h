// A rule file as the editor shows it, and its analysis.
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

/// Everything derived from one version of a text. Immutable: the background checks read it while
/// the text changes.
struct Analysis {
  explicit Analysis(dsl::LoadedRules rules);

  dsl::LoadedRules loaded;
  dsl::SymbolIndex symbols;
  std::vector<std::string> files;  ///< canonical paths of the file itself and of what it imports
  bool misses = false;             ///< an import was not found, but may appear later

  const dsl::Module& main() const { return loaded.file->main(); }
  /// The rule set; if the file has errors, only its sound rules. May be null.
  std::shared_ptr<const RuleSet> soundRules() const { return loaded.file->soundRules; }
  /// The compiled rules that an item of the file defines, mirrored rules included.
  std::vector<const dsl::CompiledRule*> rulesOf(const dsl::Symbol& rule) const;
};

struct Document {
  std::string uri, path, text;
  std::optional<int> version;      ///< no value: not open, read from the disk
  bool isChanged = false;          ///< since its diagnostics were last sent
  std::vector<Json> testFailures;  ///< diagnostics of the last test run, until the text changes
  std::shared_ptr<const Analysis> analysis;  ///< null: computed on demand
  std::shared_ptr<const Analysis> checking;  ///< the analysis for which slow checks were started
  std::vector<dsl::Diagnostic> checked;      ///< the findings of the checks so far
  std::vector<dsl::Diagnostic> withdrawn;    ///< findings of the text that the checks disprove

  /// Applies one change of textDocument/didChange: `{text}`, or `{range, text}`.
  void apply(const Json& change, Encoding encoding);
};

}  // namespace af2::lsp
