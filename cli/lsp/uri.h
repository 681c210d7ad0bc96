// Between file names and the URIs by which editors call them.
#pragma once

#include <string>
#include <string_view>

namespace af2::lsp {

/// "file:///a%20b" is /a b. Other schemes, such as untitled:, have no path: they stay as they are.
std::string pathOf(std::string_view uri);

/// The file URI of a path; relative ones are taken from the working directory.
std::string uriOf(const std::string& path);

/// A path by which the same file is always called, whether or not it is there.
std::string canonical(const std::string& path);

}  // namespace af2::lsp
