// The texts that a page consists of, besides its mesh: the files in geometry/page/web/.
// Not installed.
#pragma once

#include <string_view>

namespace af2::geometry {

/// The content of a file, named relative to geometry/page/web/, when the program was built. Throws
/// InternalError if there is no such part.
std::string_view pagePart(std::string_view name);

}  // namespace af2::geometry
