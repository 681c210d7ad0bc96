#include "cli/rules/match_arguments.h"

#include <gtest/gtest.h>

#include "cli/program/usage_error.h"

namespace af2::cli {
namespace {

TEST(MatchArguments, ReadPositions) {
  const auto match = parseMatch("--match", {"c=1.5,-0.25", "d=2e-3,+1"});
  EXPECT_EQ(match.at("c"), (Point2{1.5, -0.25}));
  EXPECT_EQ(match.at("d"), (Point2{0.002, 1}));
}

TEST(MatchArguments, ReadSegments) {
  const auto [from, to] = parseSegment("--segment", "0, 1, 2, 3");
  EXPECT_EQ(from, (Point2{0, 1}));
  EXPECT_EQ(to, (Point2{2, 3}));
}

TEST(MatchArguments, ReadValuesOfVertices) {
  const auto values = parseValues("--env", {"h=0.8", "turn(c)=120"});
  EXPECT_EQ(values.at("h"), 0.8);
  EXPECT_EQ(values.at("turn(c)"), 120);
}

TEST(MatchArguments, RefuseWhatIsNoPosition) {
  for (const char* text :
       {"", "c", "c=", "=1,1", "c=1", "c=1,2,3", "c=1,x", "c=nan,1", "c=1,1e999"}) {
    EXPECT_THROW(parseMatch("--match", {text}), UsageError) << text;
  }
  EXPECT_THROW(parseMatch("--match", {"c=1,1", "c=1,2"}), UsageError);
}

}  // namespace
}  // namespace af2::cli
