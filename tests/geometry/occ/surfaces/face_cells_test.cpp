#include "geometry/occ/surfaces/face_cells.h"

#include <gtest/gtest.h>

namespace af2::geometry {
namespace {

TEST(FaceCells, HavePlacesThatRoundingPutsOutsideTheFace) {
  const FaceCells cells{{{0, 1, 0, 1}, {1, 2, 1, 2}}, {{-3, 0, -3, 0}}};
  EXPECT_TRUE(isIn({0, 0}, cells, 0.5, -3 - 1e-15));
  EXPECT_TRUE(isIn({1, 0}, cells, 2 + 1e-15, 1e-18));
  EXPECT_FALSE(isIn({0, 0}, cells, 1.5, -1));
  EXPECT_FALSE(isIn({1, 0}, cells, 0.5, -1));
  EXPECT_FALSE(isIn({1, 0}, cells, 1 - 1e-6, -1));
  EXPECT_TRUE(isIn({1, 0}, cells, 1 - 1e-6, -1, 1e-5));
}

}  // namespace
}  // namespace af2::geometry
