#include "geometry/base/words.h"

#include <gtest/gtest.h>

#include "engine/base/error.h"

namespace af2::geometry {
namespace {

TEST(Words, FollowEachOtherOverLines) {
  Words words("some.txt", "  one\ttwo\r\n\nthree");
  EXPECT_EQ(words.next(), "one");
  EXPECT_EQ(words.next(), "two");
  EXPECT_EQ(words.next(), "three");
  EXPECT_EQ(words.next(), "");
  EXPECT_EQ(words.next(), "");
}

TEST(Words, TellTheLineOfTheLastOne) {
  Words words("some.txt", "one\n\n two");
  words.next();
  words.next();
  try {
    words.fail("is wrong");
    FAIL() << "no error";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "some.txt:3: is wrong");
  }
}

TEST(Words, GoOnAfterABackslashAtTheEndOfALine) {
  Words words("some.txt", "f 1 2 \\\r\n3\nv");
  words.next();
  EXPECT_EQ(wordsIn(words.restOfLine()), (std::vector<std::string_view>{"1", "2", "\\", "3"}));
  EXPECT_EQ(words.next(), "v");
}

TEST(Words, AreFiniteNumbersWhereOneIsAskedFor) {
  EXPECT_EQ(Words("", "+1.5e2").number(), 150);
  for (const char* wrong : {"1,5", "inf", "nan", "", "0x10", "1e999"})
    EXPECT_THROW(Words("", wrong).number(), InputError) << wrong;
}

TEST(NumberIn, TakesTheWholeWord) {
  EXPECT_EQ(numberIn<int>("+7"), 7);
  EXPECT_EQ(numberIn<int>("-7"), -7);
  EXPECT_EQ(numberIn<int>("7a"), std::nullopt);
  EXPECT_EQ(numberIn<int>(""), std::nullopt);
  EXPECT_EQ(numberIn<int>("99999999999"), std::nullopt);
}

TEST(Listed, HasTheConjunctionBeforeTheLast) {
  EXPECT_EQ(listed({}, "or"), "");
  EXPECT_EQ(listed({"a"}, "or"), "a");
  EXPECT_EQ(listed({"a", "b"}, "or"), "a or b");
  EXPECT_EQ(listed({"a", "b", "c"}, "and"), "a, b and c");
}

}  // namespace
}  // namespace af2::geometry
