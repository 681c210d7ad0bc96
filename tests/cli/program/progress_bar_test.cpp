#include "cli/program/progress_bar.h"

#include <gtest/gtest.h>

namespace af2::cli {
namespace {

TEST(ProgressLine, ShowsTheFractionAsABar) {
  EXPECT_EQ(progressLine("meshing", 0.5, "3/6 faces", 80),
            "meshing " + std::string(20, '#') + std::string(20, '-') + "  50 %  3/6 faces");
}

TEST(ProgressLine, NeverExceedsTheWidth) {
  for (int width = 0; width < 100; ++width) {
    EXPECT_LE(progressLine("meshing", 0.3, "3/6 faces", width).size(),
              static_cast<std::size_t>(width));
  }
}

TEST(ProgressLine, ClampsTheFraction) {
  EXPECT_NE(progressLine("x", 7, "", 80).find("100 %"), std::string::npos);
  EXPECT_NE(progressLine("x", -1, "", 80).find("  0 %"), std::string::npos);
}

TEST(ProgressLine, ShowsHundredPercentOnlyAtTheEnd) {
  EXPECT_NE(progressLine("x", 0.999, "", 80).find(" 99 %"), std::string::npos);
}

}  // namespace
}  // namespace af2::cli
