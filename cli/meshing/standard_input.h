// A model that comes through standard input.
#pragma once

#include <memory>
#include <string>

#include "cli/program/temporary_file.h"

namespace af2::cli {

/// Whether an argument means standard input: "-" or "/dev/stdin".
bool isStandardInput(const std::string& model);

/// The extension of the format that a model has by its content, with the dot; empty if that cannot
/// be told.
std::string extensionByContent(const std::string& content);

/// A file with what standard input has to its end, named so that its extension tells the format.
///
/// format  the name of an extension, without the dot; empty: the content tells
///
/// Throws UsageError if there is no such format, InputError if nothing comes, or nothing that tells
/// its format.
std::unique_ptr<TemporaryFile> takeStandardInput(const std::string& format);

}  // namespace af2::cli
