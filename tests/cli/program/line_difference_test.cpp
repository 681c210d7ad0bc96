#include "cli/program/line_difference.h"

#include <gtest/gtest.h>

namespace af2::cli {
namespace {

TEST(LineDifference, OfEqualTextsIsEmpty) {
  EXPECT_EQ(lineDifference("f", "one\ntwo\n", "one\ntwo\n"), "");
}

TEST(LineDifference, ShowsAChangeWithThreeLinesAroundIt) {
  EXPECT_EQ(lineDifference("f", "1\n2\n3\n4\nold\n6\n7\n8\n9\n", "1\n2\n3\n4\nnew\n6\n7\n8\n9\n"),
            "--- f\n+++ f (formatted)\n@@ -2 +2 @@\n 2\n 3\n 4\n-old\n+new\n 6\n 7\n 8\n");
}

TEST(LineDifference, FindsLinesThatStayBetweenChanges) {
  EXPECT_EQ(lineDifference("f", "a\nkept\nb\n", "kept\nc\n"),
            "--- f\n+++ f (formatted)\n@@ -1 +1 @@\n-a\n kept\n-b\n+c\n");
}

}  // namespace
}  // namespace af2::cli
