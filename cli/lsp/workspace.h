// Names across files: those that are open, and those in the folders of the workspace.
#pragma once

#include <string>
#include <vector>

#include "cli/lsp/session.h"

namespace af2::lsp {

/// Where a symbol is written in one file, in the order of the text.
struct FileOccurrences {
  std::string uri, text;
  std::optional<int> version;  ///< of an open document
  std::vector<dsl::Occurrence> occurrences;
};

/// All places at which a symbol of the place's analysis is written: in its own file, in those that
/// are open, and, for names that other files can import, in the rule files of the workspace.
std::vector<FileOccurrences> occurrencesEverywhere(const Session& session, const Place& place,
                                                   std::size_t symbol);

/// The rule files below the folders of the workspace and beside the documents, at most a few
/// hundred, in the order of their paths.
std::vector<std::string> ruleFilesOf(const Session& session);

}  // namespace af2::lsp
