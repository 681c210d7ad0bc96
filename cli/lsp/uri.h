// Conversions between file names and the URIs that editors use for them.
#pragma once

#include <string>
#include <string_view>

namespace af2::lsp {

/// "file:///a%20b" is /a b. Other schemes, such as untitled:, have no path and are returned
/// unchanged.
std::string pathOf(std::string_view uri);

/// The file URI of a path; relative paths start at the working directory.
std::string uriOf(const std::string& path);

/// The canonical path of a file, whether or not it exists, so that a file always has one name.
std::string canonical(const std::string& path);

}  // namespace af2::lsp
