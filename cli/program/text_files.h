// Small text files that verbs write.
#pragma once

#include <string>
#include <string_view>

namespace af2::cli {

/// Writes the file whole or not at all; "-" is standard output. Throws UsageError if the file
/// cannot be written.
void writeText(const std::string& path, std::string_view text);

}  // namespace af2::cli
