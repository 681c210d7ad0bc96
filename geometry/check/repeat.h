// How checks repeat something.
#pragma once

#include <cstddef>
#include <functional>

namespace af2::geometry {

/// Calls work(0), ..., work(count - 1), perhaps several at once.
using Repeat = std::function<void(std::size_t count, const std::function<void(std::size_t)>& work)>;

inline const Repeat kOneByOne = [](std::size_t count,
                                   const std::function<void(std::size_t)>& work) {
  for (std::size_t i = 0; i < count; ++i) work(i);
};

}  // namespace af2::geometry
