#include "geometry/fill/first_diagonals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "tests/support/flat_surface.h"

namespace af2::geometry {
namespace {

/// 0 to 4 lie on the boundary, 5 lies inside.
struct OneElement {
  Mesh mesh;
  MeshBoundary boundary;

  OneElement() {
    FrontInput input;
    testing::addLoop(input, {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}});
    boundary = boundaryOf(input);
    for (const auto& corner : input.loops[0]) mesh.vertices.push_back(corner.point);
    mesh.vertices.push_back(testing::flatCorner(5, {1, 0.8}).point);
  }
  std::uint32_t firstCornerOf(std::array<std::uint32_t, 4> corners) {
    Element element;
    for (std::size_t i = 0; i < 4; ++i) element.corners[i] = VertexId(corners[i]);
    mesh.elements = {element};
    beginAtBoundaryCorners(boundary, mesh);
    for (std::size_t i = 0; i < 4; ++i) {  // the same way round
      const auto at = std::ranges::find(element.corners, mesh.elements[0].corners[i]);
      EXPECT_EQ(mesh.elements[0].corners[(i + 1) % 4],
                element.corners[static_cast<std::size_t>(at - element.corners.begin() + 1) % 4]);
    }
    return mesh.elements[0].corners[0].value;
  }
};

TEST(FirstDiagonals, AreThoseAtCornersOfTheBoundary) {
  for (const std::array<std::uint32_t, 4>& corners :
       {std::array<std::uint32_t, 4>{4, 0, 1, 5}, {0, 1, 5, 4}, {1, 5, 4, 0}, {5, 4, 0, 1}})
    EXPECT_EQ(OneElement().firstCornerOf(corners), 0u);
}

TEST(FirstDiagonals, StayWhereNoTwoSidesLieOnTheBoundary) {
  EXPECT_EQ(OneElement().firstCornerOf({1, 2, 3, 5}), 2u);
  EXPECT_EQ(OneElement().firstCornerOf({0, 1, 5, 3}), 0u);
  EXPECT_EQ(OneElement().firstCornerOf({5, 3, 0, 1}), 5u);
}

}  // namespace
}  // namespace af2::geometry
