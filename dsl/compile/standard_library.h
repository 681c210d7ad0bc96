// Rule files that come with AF2 and are imported by names that begin with "std/".
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace af2::dsl {

/// The text of a file such as "std/quality.af2"; nothing if there is no such file.
std::optional<std::string> standardFile(std::string_view path);

}  // namespace af2::dsl
