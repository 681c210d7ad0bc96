#include "engine/mesh/element_shape.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace af2 {
namespace {

TEST(ElementShape, WhatIsPlainlyBelowALimitIsBelowIt) {
  constexpr double kLimit = 1.2;
  std::mt19937 random(5);
  std::normal_distribution<double> about(0, 0.35);
  int below = 0, plainly = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto corner = [&](double x, double y) {
      const Point3 normal{about(random), about(random), 1};
      return SurfacePoint{{x + about(random), y + about(random), about(random)}, unit(normal)};
    };
    const SurfacePoint a = corner(0, 0), b = corner(1, 0), c = corner(0.5, 0.866);
    const bool isBelow = triangleDistortion(a, b, c) < kLimit;
    below += isBelow;
    if (!isPlainlyBelow(kLimit, a, b, c)) continue;
    ++plainly;
    EXPECT_TRUE(isBelow);
  }
  EXPECT_GT(below, 1000);
  EXPECT_EQ(plainly, below) << "only what is within rounding of the limit is not told";
}

TEST(ElementShape, AFoldIsNotPlainlyBelowAnything) {
  const Point3 up{0, 0, 1};
  const SurfacePoint a{{0, 0, 0}, up}, b{{1, 0, 0}, up}, c{{0.5, 0.866, 0}, up};
  EXPECT_TRUE(isPlainlyBelow(1.1, a, b, c));
  EXPECT_FALSE(isPlainlyBelow(1e9, b, a, c));
}

/// A reflex corner where normals are unknown, as beside singular parameters.
TEST(ElementShape, SeesReflexCornersWithoutNormals) {
  Mesh mesh;
  mesh.vertices.resize(4);
  mesh.vertices[1].position = {2, 0, 0};
  mesh.vertices[2].position = {0.5, 0.5, 0};
  mesh.vertices[3].position = {0, 2, 0};
  const Element element{{VertexId(0), VertexId(1), VertexId(2), VertexId(3)}};
  const auto distortion = [&] {
    std::array<const SurfacePoint*, 4> corners{};
    for (std::size_t i = 0; i < 4; ++i) corners[i] = &mesh.vertices[i];
    return elementDistortion(corners);
  };
  EXPECT_TRUE(leans(mesh, element));
  EXPECT_EQ(distortion(), INFINITY);
  mesh.vertices[2].position = {2, 2, 0};
  EXPECT_FALSE(leans(mesh, element));
  EXPECT_NEAR(distortion(), 1, 1e-12);
}

}  // namespace
}  // namespace af2
