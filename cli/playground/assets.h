// The files that the page of the playground consists of, from web/.
#pragma once

#include <string>
#include <string_view>

namespace af2::playground {

struct Asset {
  std::string_view text;
  std::string type;  ///< its Content-Type
};

/// The content when the program was built. `text` has no data if there is no such file.
Asset findAsset(std::string_view name);

}  // namespace af2::playground
