#include "geometry/meshing/first_faces.h"

#include <gtest/gtest.h>

namespace af2::geometry {
namespace {

TEST(FirstFaces, AreTheSmallOnes) {
  EXPECT_EQ(smallFaces({50, 3, 40, 3, 4}), (std::vector<bool>{false, true, false, true, true}));
}

TEST(FirstFaces, AreNoneWhereEachIsLarge) {
  EXPECT_EQ(smallFaces({10}), std::vector<bool>{false});
  EXPECT_EQ(smallFaces({10, 10}), (std::vector<bool>{false, false}));
}

TEST(FirstFaces, OfTheSameSizeComeInTheirOrder) {
  EXPECT_EQ(smallFaces(std::vector<double>(6, 1)),
            (std::vector<bool>{true, false, false, false, false, false}));
}

}  // namespace
}  // namespace af2::geometry
