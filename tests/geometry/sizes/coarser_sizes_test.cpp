#include "geometry/sizes/coarser_sizes.h"

#include <gtest/gtest.h>

namespace af2::geometry {
namespace {

TEST(CoarserSizes, AreLargerFromEachSource) {
  Sizes sizes;
  sizes.size = 2;
  sizes.minSize = 0.5;
  sizes.faceSizes = {{3, 1.5}};
  sizes.edgeNames = {{"inlet", 0.25}};
  sizes.sources.boxes.push_back({{0, 0, 0}, {1, 1, 1}, 0.1});
  sizes.sources.grids.push_back({{0, 0, 0}, {1, 1, 1}, {2, 1, 1}, {0.1, 0.2}});
  sizes.sources.cells.push_back(
      {{{0, 0, 0}}, {0.3}, {{0, SizeCells::kNone, SizeCells::kNone, SizeCells::kNone}}});
  sizes.function = [](const Point3& at) { return 1 + at.x; };
  sizes.elementsPerTurn = 12;
  sizes.elementsAcross = 4;
  sizes.chords.everywhere = {0.01, false};
  const Sizes larger = timesAsLarge(sizes, 2);
  EXPECT_EQ(larger.size, 4);
  EXPECT_EQ(larger.minSize, 1);
  EXPECT_EQ(larger.maxSize, sizes.maxSize) << "there was no bound";
  EXPECT_EQ(larger.faceSizes.at(3), 3);
  EXPECT_EQ(larger.edgeNames.front().second, 0.5);
  EXPECT_EQ(larger.sources.boxes.front().size, 0.2);
  EXPECT_EQ(larger.sources.grids.front().sizes, (std::vector<double>{0.2, 0.4}));
  EXPECT_EQ(larger.sources.cells.front().sizes, (std::vector<double>{0.6}));
  EXPECT_EQ(larger.function.at({3, 0, 0}), 8);
  EXPECT_EQ(larger.elementsPerTurn, 6);
  EXPECT_EQ(larger.elementsAcross, 2);
  EXPECT_EQ(larger.chords.everywhere.value, 0.04);
  checkSizes(larger);
}

TEST(CoarserSizes, KeepThreeElementsAroundATurn) {
  Sizes sizes;
  sizes.size = 1;
  sizes.elementsPerTurn = 12;
  EXPECT_EQ(timesAsLarge(sizes, 10).elementsPerTurn, 3);
}

}  // namespace
}  // namespace af2::geometry
