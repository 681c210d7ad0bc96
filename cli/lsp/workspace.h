// Names across files: open files, and files in the folders of the workspace.
#pragma once

#include <string>
#include <vector>

#include "cli/lsp/session.h"

namespace af2::lsp {

/// The occurrences of a symbol in one file, in the order of the text.
struct FileOccurrences {
  std::string uri, text;
  std::optional<int> version;  ///< version of an open document
  std::vector<dsl::Occurrence> occurrences;
};

/// All occurrences of a symbol: in its own file, in open files and, for names that other files can
/// import, in the rule files of the workspace.
std::vector<FileOccurrences> occurrencesEverywhere(const Session& session, const Place& place,
                                                   std::size_t symbol);

/// The rule files below the folders of the workspace and beside the documents, at most a few
/// hundred, sorted by path.
std::vector<std::string> ruleFilesOf(const Session& session);

}  // namespace af2::lsp
