#include "geometry/check/drawn_part.h"
#include "tests/support/element.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace af2::geometry {
namespace {

using testing::v;

/// A strip of `steps` squares along a curve, 1 wide, in two triangles each.
template <class Place>
ModelMesh strip(std::size_t steps, const Place& place) {
  ModelMesh mesh;
  for (std::size_t i = 0; i <= steps; ++i)
    for (const double side : {0.0, 1.0}) mesh.vertices.push_back(place(i, side));
  for (std::size_t i = 0; i < steps; ++i) {
    const std::size_t a = 2 * i;
    mesh.elements.push_back({{v(a), v(a + 1), v(a + 3), VertexId()}});
    mesh.elements.push_back({{v(a), v(a + 3), v(a + 2), VertexId()}});
  }
  mesh.face.assign(mesh.elements.size(), 1);
  return mesh;
}

/// A spiral staircase of so many turns, 24 squares to a turn.
ModelMesh staircase(double turns) {
  return strip(static_cast<std::size_t>(24 * turns), [](std::size_t i, double side) {
    const double angle = 2 * M_PI * static_cast<double>(i) / 24, radius = 2 - side;
    return Point3{radius * std::cos(angle), radius * std::sin(angle), static_cast<double>(i) / 24};
  });
}

bool isDrawable(const ModelMesh& mesh) { return canBeDrawn({mesh, 0, mesh.elements.size()}); }

TEST(DrawnPart, AStaircaseLiesOverItselfAfterATurn) {
  EXPECT_TRUE(isDrawable(staircase(0.5)));
  EXPECT_TRUE(isDrawable(staircase(0.9)));
  EXPECT_FALSE(isDrawable(staircase(1.2)));
  EXPECT_FALSE(isDrawable(staircase(2.5)));
}

TEST(DrawnPart, ATubeIsSeenFromOneSideByHalves) {
  const auto tube = [](double angle) {
    return strip(40, [&](std::size_t i, double side) {
      const double t = angle * static_cast<double>(i) / 40;
      return Point3{-std::cos(t), side, std::sin(t)};
    });
  };
  EXPECT_TRUE(isDrawable(tube(0.9 * M_PI)));
  EXPECT_FALSE(isDrawable(tube(1.1 * M_PI)));
}

/// Triangles around the origin, each from one angle to another, in degrees; the origin is theirs.
ModelMesh fans(const std::vector<std::pair<double, double>>& sectors) {
  ModelMesh mesh;
  mesh.vertices.push_back({0, 0, 0});
  for (const auto& sector : sectors) {
    const std::size_t first = mesh.vertices.size();
    for (const double degrees : {sector.first, sector.second})
      mesh.vertices.push_back({std::cos(degrees * M_PI / 180), std::sin(degrees * M_PI / 180),
                               0.01 * static_cast<double>(first)});
    mesh.elements.push_back({{v(0), v(first), v(first + 1), VertexId()}});
  }
  mesh.face.assign(mesh.elements.size(), 1);
  return mesh;
}

TEST(DrawnPart, MayTouchItselfAtAVertex) {
  EXPECT_TRUE(isDrawable(fans({{10, 60}, {100, 150}, {200, 300}})));
  EXPECT_FALSE(isDrawable(fans({{10, 60}, {100, 150}, {120, 200}})));  // two overlap
  EXPECT_FALSE(isDrawable(fans({{10, 150}, {40, 80}})));               // one lies on the other
}

TEST(DrawnPart, MayBeApartButNotOneOverTheOther) {
  ModelMesh mesh = fans({{0, 90}});
  for (const Point3& p : {Point3{3, 0, 0}, Point3{4, 0, 0}, Point3{3, 1, 0}})
    mesh.vertices.push_back(p);
  mesh.elements.push_back({{v(3), v(4), v(5), VertexId()}});
  EXPECT_TRUE(isDrawable(mesh));
  mesh.vertices[3] = {0.2, 0.2, 1};  // within the other one's shadow
  mesh.vertices[4] = {0.4, 0.2, 1};
  mesh.vertices[5] = {0.2, 0.4, 1};
  EXPECT_FALSE(isDrawable(mesh));
}

TEST(DrawnPart, IsGivenByPlacesToo) {
  const ModelMesh mesh = staircase(1.2);
  std::vector<std::uint32_t> firstHalf;
  for (std::uint32_t i = 0; i < 24; ++i) firstHalf.push_back(23 - i);
  EXPECT_TRUE(canBeDrawn({mesh, 0, firstHalf.size(), firstHalf.data()}));
  EXPECT_TRUE(canBeDrawn({mesh, 10, firstHalf.size(), firstHalf.data()}));
}

TEST(DrawnPart, ElementsMustBeOrientedAlike) {
  ModelMesh mesh = strip(4, [](std::size_t i, double side) {
    return Point3{side, static_cast<double>(i), 0};
  });
  EXPECT_TRUE(isDrawable(mesh));
  std::swap(mesh.elements[3].corners[0], mesh.elements[3].corners[1]);
  EXPECT_FALSE(isDrawable(mesh));
}

}  // namespace
}  // namespace af2::geometry
