#include "geometry/planar/poly_file.h"

#include "tests/geometry/planar/poly_text.h"

namespace af2::geometry {
namespace {

using testing::messageOf;
using testing::polyOf;

TEST(PolyFile, IsReadWithCommentsAttributesAndMarkers) {
  const PlanarDomain domain = polyOf(
      "# a triangle\n"
      "3 2 1 1\n"
      "1 0 0 7.5 3\n"
      "\n"
      "2 1e0 0 7.5 3  # the second\n"
      "3 +0.5 1 7.5 3\n"
      "3 1\n"
      "1 1 2 4\n"
      "2 2 3 5\n"
      "3 3 1 6\n"
      "1\n"
      "1 0.5 0.25\n"
      "1\n"
      "1 0.5 0.25 1 0.1\n");
  EXPECT_EQ(domain.points, (std::vector<Point2>{{0, 0}, {1, 0}, {0.5, 1}}));
  ASSERT_EQ(domain.segments.size(), 3u);
  EXPECT_EQ(domain.segments[2].from, 2);
  EXPECT_EQ(domain.segments[2].to, 0);
  EXPECT_EQ(domain.segments[2].marker, 6);
  EXPECT_EQ(domain.segments[2].line, 10);
  EXPECT_EQ(domain.holes, (std::vector<Point2>{{0.5, 0.25}}));
}

TEST(PolyFile, MayNumberItsVerticesFromZero) {
  const PlanarDomain domain = polyOf("2 2 0 0\n0 3 4\n1 5 6\n1 0\n0 0 1\n0\n");
  EXPECT_EQ(domain.segments[0].from, 0);
  EXPECT_EQ(domain.segments[0].to, 1);
}

TEST(PolyFile, MayHaveItsVerticesInANodeFileBeside) {
  const testing::TestFolder folder;
  folder.write("test.node", "2 2 0 0\n1 3 4\n2 5 6\n");
  EXPECT_EQ(readPoly(folder.write("test.poly", "0 2 0 0\n1 0\n1 1 2\n0\n")).points,
            (std::vector<Point2>{{3, 4}, {5, 6}}));
}

TEST(PolyFile, TellsTheLineOfAMistake) {
  EXPECT_EQ(messageOf([] { polyOf("2 2 0 0\n1 0 0\n2 x 0\n"); }),
            "test.poly:3: 'x' is not a number; expected x");
  EXPECT_EQ(messageOf([] { polyOf("2 2 0 0\n1 0 0\n2 1\n"); }),
            "test.poly:3: the line is too short; y is missing");
  EXPECT_EQ(messageOf([] { polyOf("2 2 0 0\n1 0 0\n2 1 0\n1 0\n1 1 3\n"); }),
            "test.poly:5: there is no vertex 3; they are numbered 1 to 2");
  EXPECT_EQ(messageOf([] { polyOf("2 2 0 0\n1 0 0\n1 1 0\n"); }),
            "test.poly:3: vertex 1 is defined a second time");
  EXPECT_EQ(messageOf([] { polyOf("3 2 0 0\n1 0 0\n2 1 0\n"); }),
            "test.poly:4: the file ends before vertex 3 of 3");
  EXPECT_EQ(
      messageOf([] { polyOf("1 3 0 0\n1 0 0 0\n"); }),
      "test.poly:1: the dimension is not 2; only planar domains can be read from this format");
  EXPECT_EQ(messageOf([] { polyOf("1 2 0 0\n1 0 inf\n"); }),
            "test.poly:2: 'inf' is not a number; expected y");
}

TEST(PolyFile, TellsWhenItIsMissingOrEmpty) {
  EXPECT_NE(messageOf([] { readPoly("/nowhere/test.poly"); }).find("cannot be opened"),
            std::string::npos);
  EXPECT_EQ(messageOf([] { polyOf(""); }),
            "test.poly:1: the file ends before the number of vertices");
}

}  // namespace
}  // namespace af2::geometry
