#include "cli/program/number_lists.h"

#include <gtest/gtest.h>

#include "cli/program/usage_error.h"

namespace af2::cli {
namespace {

template <class Parse>
std::string refusal(Parse parse) {
  try {
    parse();
  } catch (const UsageError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ParseIds, TakesNumbersAndRangesInAnyOrder) {
  EXPECT_EQ(parseIds("--faces", "7-9,3,8"), (std::vector<int>{3, 7, 8, 9}));
  EXPECT_EQ(parseIds("--faces", "1"), (std::vector<int>{1}));
}

TEST(ParseIds, RefusesWhatIsNoId) {
  for (const char* text : {"", "0", "-1", "a", "1,,2", "3-", "9-7", "1.5", "1 ", "99999999999"}) {
    EXPECT_THROW(parseIds("--faces", text), UsageError) << text;
  }
  EXPECT_EQ(
      refusal([] { parseIds("--faces", "1,x"); }),
      "--faces '1,x': 'x' is neither a number nor a range; write e.g. 3,7-9 (counted from 1)");
}

TEST(ParseSize, TakesPositiveNumbers) {
  EXPECT_EQ(parseSize("--size", "0.5"), 0.5);
  EXPECT_EQ(parseSize("--size", "1e-3"), 1e-3);
}

TEST(ParseSize, RefusesWhatIsNoLength) {
  for (const char* text : {"", "0", "-1", "nan", "inf", "1e999", "1mm", "0,5"}) {
    EXPECT_THROW(parseSize("--size", text), UsageError) << text;
  }
}

TEST(ParseFaceSizes, LetsTheLastOneWin) {
  const auto parsed = [](const std::vector<std::string>& texts) {
    return parseFaceSizes("--edge-size", texts, "edge").byId;
  };
  EXPECT_EQ(parsed({"1-3=0.5", "2=0.1"}), (std::map<int, double>{{1, 0.5}, {2, 0.1}, {3, 0.5}}));
  EXPECT_THROW(parsed({"3"}), UsageError);
  EXPECT_THROW(parsed({"3=0"}), UsageError);
  EXPECT_THROW(parsed({"=1"}), UsageError);
}

TEST(NumberLists, OfFacesMayHaveNames) {
  const FaceList faces = parseFaces("--faces", "7-9,inlet,3,bolt 2*");
  EXPECT_EQ(faces.ids, (std::vector<int>{3, 7, 8, 9}));
  EXPECT_EQ(faces.names, (std::vector<std::string>{"inlet", "bolt 2*"}));
  EXPECT_THROW(parseFaces("--faces", "3,,4"), UsageError);
  EXPECT_THROW(parseFaces("--faces", "3x"), UsageError);
  const FaceSizeList sizes = parseFaceSizes("--face-size", {"1,lid=0.5", "a=b=0.1", "1=0.2"});
  EXPECT_EQ(sizes.byId, (std::map<int, double>{{1, 0.2}}));
  EXPECT_EQ(sizes.byName,
            (std::vector<std::pair<std::string, double>>{{"lid", 0.5}, {"a=b", 0.1}}));
  EXPECT_THROW(parseFaceSizes("--face-size", {"lid"}), UsageError);
  EXPECT_THROW(parseFaceSizes("--face-size", {"lid=0"}), UsageError);
}

}  // namespace
}  // namespace af2::cli
