#include "geometry/io/points_file.h"

#include "tests/geometry/planar/poly_text.h"

namespace af2::geometry {
namespace {

InsideFaces insideOf(const std::string& text) {
  return readInsideFaces(testing::TestFile("test.poly", text).path());
}

TEST(PointsFile, HoldsPointsAndCurves) {
  const InsideFaces inside =
      insideOf(R"({"points": [[1, 2, 3], [4, 5]], "curves": [[[0, 0], [1, 0], [1, 1, 2]]]})");
  EXPECT_EQ(inside.points, (std::vector<Point3>{{1, 2, 3}, {4, 5, 0}}));
  ASSERT_EQ(inside.curves.size(), 1u);
  EXPECT_EQ(inside.curves[0], (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 2}}));
  EXPECT_TRUE(insideOf(R"({"curves": []})").isEmpty());
}

TEST(PointsFile, TellsWhatIsWrong) {
  const auto fault = [](const std::string& text) {
    return testing::messageOf([&] { insideOf(text); });
  };
  EXPECT_NE(fault("{}").find("'points' is missing"), std::string::npos);
  EXPECT_NE(fault(R"({"lines": []})").find("points, curves"), std::string::npos);
  EXPECT_NE(fault(R"({"curves": [[[0, 0]]]})").find("at least two points"), std::string::npos);
  EXPECT_NE(fault(R"({"curves": [[0, 0]]})").find("list of numbers"), std::string::npos);
  EXPECT_NE(fault(R"({"points": [[1]]})").find("two or three"), std::string::npos);
}

}  // namespace
}  // namespace af2::geometry
