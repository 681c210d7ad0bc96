#include "dsl/proof/test_text.h"

#include <gtest/gtest.h>

#include "quad_rules.h"

namespace af2::dsl {
namespace {

TEST(TestText, WritesChainsPointsAndLevel) {
  const AF2Rule rule = testing::twoHeightsVisAVis();
  const PatternMatch match(rule, {{0, 0}, {1, 0}, {1.5, 1.25}, {0, 2}}, 3);
  EXPECT_EQ(writeTest(match, {"an obstacle is seen", {{0.5, 0.25}}, "not rule \"x\""}),
            "test \"an obstacle is seen\" {\n"
            "  front a (0, 0) -> b (1, 0), c (1.5, 1.25) -> d (0, 2);\n"
            "  point o (0.5, 0.25);\n"
            "  base a -> b;\n"
            "  class 3;\n"
            "  expect not rule \"x\";\n"
            "}\n");
}

TEST(TestText, WritesClosedChains) {
  const AF2Rule rule = testing::fillQuad();
  const PatternMatch match(rule, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);
  EXPECT_EQ(writeTest(match, {"closes", {}, "elements 1"}),
            "test \"closes\" {\n"
            "  front a (0, 0) -> b (1, 0) -> c (1, 1) -> d (0, 1) -> a;\n"
            "  base a -> b;\n"
            "  expect elements 1;\n"
            "}\n");
}

}  // namespace
}  // namespace af2::dsl
