#include "geometry/planar/loops.h"

#include "tests/geometry/planar/poly_text.h"

namespace af2::geometry {
namespace {

/// A domain of closed outlines, one after the other.
PlanarDomain outlines(const std::vector<std::vector<Point2>>& loops,
                      std::vector<Point2> holes = {}) {
  PlanarDomain domain;
  domain.name = "test.poly";
  domain.holes = std::move(holes);
  for (const auto& loop : loops) {
    const int base = static_cast<int>(domain.points.size());
    const int count = static_cast<int>(loop.size());
    domain.points.insert(domain.points.end(), loop.begin(), loop.end());
    for (int i = 0; i < count; ++i)
      domain.segments.push_back(
          {base + i, base + (i + 1) % count, 0, static_cast<int>(domain.segments.size()) + 1});
  }
  return domain;
}

std::vector<Point2> square(double x, double y, double size) {
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

std::vector<double> areas(const PlanarDomain& domain) {
  std::vector<double> result;
  for (const PlanarRegion& region : findRegions(domain).regions) result.push_back(region.area);
  return result;
}

TEST(Regions, LeaveOutHolesByTheirPoints) {
  EXPECT_EQ(areas(outlines({square(0, 0, 4), square(1, 1, 2)}, {{2, 2}})),
            (std::vector<double>{12}));
}

TEST(Regions, AreMeshedOnBothSidesOfAnOutlineWithoutHolePoint) {
  EXPECT_EQ(areas(outlines({square(0, 0, 4), square(1, 1, 2)})), (std::vector<double>{12, 4}));
}

TEST(Regions, TellOfPointsThatHaveNoEffect) {
  PlanarDomain domain = outlines({square(0, 0, 4), square(1, 1, 2)}, {{2, 2}, {9, 9}});
  domain.regionPoints = {{{0.5, 0.5}, 7}, {{3.5, 3.5}, 7}, {{0.5, 3.5}, 8}, {{2, 2}, 9}};
  const PlanarRegions found = findRegions(domain);
  ASSERT_EQ(found.regions.size(), 1u);
  EXPECT_EQ(found.regions[0].domain, 7);
  ASSERT_EQ(found.notes.size(), 3u);
  EXPECT_EQ(found.notes[0].find("hole point 2 at (9, 9) is outside"), 0u) << found.notes[0];
  EXPECT_EQ(found.notes[1].find("region point 3 at (0.5, 3.5) is in the same"), 0u);
  EXPECT_EQ(found.notes[2].find("region point 4 at (2, 2) is in no region"), 0u);
}

TEST(Regions, MayHaveIslandsInTheirHoles) {
  EXPECT_EQ(areas(outlines({square(0, 0, 6), square(1, 1, 4), square(2, 2, 2)}, {{1.5, 1.5}})),
            (std::vector<double>{20, 4}));
}

TEST(Regions, DoNotDependOnTheSenseOfOutlines) {
  auto hole = square(1, 1, 2);
  std::reverse(hole.begin(), hole.end());
  EXPECT_EQ(areas(outlines({square(0, 0, 4), hole}, {{2, 2}})), (std::vector<double>{12}));
}

TEST(Regions, MayTouchInAPoint) {
  EXPECT_EQ(areas(outlines({square(0, 0, 1), square(1, 1, 1)})), (std::vector<double>{1, 1}));
  EXPECT_EQ(areas(outlines({square(0, 0, 4), {{0, 2}, {2, 1}, {2, 3}}}, {{1, 2}})),
            (std::vector<double>{14}));  // the hole touches the side, which is split there
}

TEST(Regions, MayShareASegment) {
  const PlanarRegions regions = findRegions(outlines({square(0, 0, 1), square(1, 0, 1)}));
  EXPECT_EQ(regions.regions.size(), 2u);
  EXPECT_EQ(regions.pieces.size(), 7u);
  EXPECT_EQ(regions.points.size(), 6u);
}

/// A square, and a segment by itself between points 4 and 5, at (2, 2) and (2, 3).
PlanarDomain squareAndSegment(double size) {
  PlanarDomain domain = outlines({square(0, 0, size)});
  domain.points.push_back({2, 2});
  domain.points.push_back({2, 3});
  domain.segments.push_back({4, 5, 0, 5});
  return domain;
}

TEST(Regions, KeepSegmentsThatEndInside) {
  PlanarDomain domain = squareAndSegment(4);
  domain.segments.push_back({0, 4, 0, 6});  // joins it to a corner
  const PlanarRegions regions = findRegions(domain);
  ASSERT_EQ(regions.regions.size(), 1u);
  EXPECT_EQ(regions.regions[0].area, 16);
  EXPECT_EQ(regions.regions[0].loops.size(), 1u);
  EXPECT_EQ(regions.regions[0].loops[0].size(), 8u);
}

TEST(Regions, KeepSegmentsThatLieFreeInside) {
  const PlanarRegions regions = findRegions(squareAndSegment(4));
  ASSERT_EQ(regions.regions[0].loops.size(), 2u);
  EXPECT_EQ(regions.regions[0].loops[1].size(), 2u);
}

/// A test of time would be one of the machine: this many points take minutes if each looks at all
/// the others.
TEST(Regions, OfVeryLongOutlinesAndManyHolesAreFoundSoon) {
  constexpr int kPoints = 150'000, kHoles = 20;  // holes along each side
  std::vector<Point2> round, upright{{300, 0}, {400, 0}};
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2 * M_PI * i / kPoints;
    round.push_back({100 * std::cos(angle), 100 * std::sin(angle)});
    upright.push_back({400, 1.0 + i});  // all in one line
  }
  std::vector<std::vector<Point2>> all{round, upright};
  for (int i = 0; i < kHoles; ++i)
    for (int k = 0; k < kHoles; ++k) all.push_back(square(i - 30, k - 30, 0.5));
  const PlanarRegions regions = findRegions(outlines(all));
  EXPECT_EQ(regions.regions.size(), 2u + kHoles * kHoles);
}

TEST(Regions, IgnoreSegmentsOutside) {
  EXPECT_EQ(areas(squareAndSegment(1)), (std::vector<double>{1}));
}

TEST(Regions, RefuseCrossingSegmentsWithTheirLines) {
  EXPECT_EQ(
      testing::messageOf([] {
        findRegions(outlines({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}));
      }),
      "test.poly:3: this segment crosses the one in line 1; put a vertex where they cross and "
      "split both there");
}

TEST(Regions, RefuseADomainThatEnclosesNothing) {
  PlanarDomain open = outlines({square(0, 0, 1)});
  open.segments.pop_back();
  EXPECT_EQ(testing::messageOf([&] { findRegions(open); }),
            "test.poly: its segments enclose nothing; each outline must be closed");
  EXPECT_EQ(testing::messageOf([] {
              findRegions(outlines({square(0, 0, 1)}, {{0.5, 0.5}}));
            }),
            "test.poly: every region that its segments enclose is a hole");
}

}  // namespace
}  // namespace af2::geometry
