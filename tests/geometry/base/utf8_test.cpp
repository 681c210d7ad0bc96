#include "geometry/base/utf8.h"

#include <gtest/gtest.h>

namespace af2::geometry {
namespace {

TEST(Utf8, AcceptsCharactersOfAllLengths) {
  EXPECT_TRUE(isUtf8(""));
  EXPECT_TRUE(isUtf8("plain"));
  EXPECT_TRUE(isUtf8("T\xc3\xa4l \xe2\x82\xac \xf0\x9f\x98\x80"));
}

TEST(Utf8, RejectsOtherEncodingsAndCutCharacters) {
  EXPECT_FALSE(isUtf8("T\xe4l"));                // Latin-1
  EXPECT_FALSE(isUtf8("\x83\x8a\x83\x93\x83"));  // Shift-JIS
  EXPECT_FALSE(isUtf8("\xc3"));
  EXPECT_FALSE(isUtf8("\xc0\xaf"));      // longer than needed
  EXPECT_FALSE(isUtf8("\xed\xa0\x80"));  // half a pair of UTF-16
}

}  // namespace
}  // namespace af2::geometry
