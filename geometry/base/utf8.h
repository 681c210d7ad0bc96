// Recognises UTF-8.
#pragma once

#include <string_view>

namespace af2::geometry {

/// Whether a text is well-formed UTF-8.
bool isUtf8(std::string_view text);

}  // namespace af2::geometry
