#include "engine/base/stream_text.h"

#include <gtest/gtest.h>

#include <sstream>

namespace af2 {
namespace {

TEST(RestOf, IsTheWholeTextWhateverItsLength) {
  for (const std::size_t length : {0u, 1u, 16383u, 16384u, 16385u, 100000u}) {
    std::string text(length, 'a');
    for (std::size_t i = 0; i < length; ++i) text[i] = static_cast<char>('a' + i % 23);
    std::istringstream in("x" + text);
    in.get();
    EXPECT_EQ(restOf(in), text);
  }
}

TEST(RestOf, IsCutAtTheLimit) {
  for (const std::size_t most : {0u, 3u, 20000u}) {
    std::istringstream in(std::string(50000, 'b'));
    EXPECT_EQ(restOf(in, most), std::string(most, 'b'));
  }
}

}  // namespace
}  // namespace af2
