// Noise along feature edges, as triangulations of CAD surfaces have it: triangles far smaller than
// an element, which look anywhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "geometry/faceted/patches.h"
#include "geometry/mesh/quality.h"
#include "tests/geometry/faceted/faceted_mesh.h"
#include "tests/geometry/faceted/sheets.h"

namespace af2::geometry {
namespace {

/// Two triangles, which look forward, and to the left or right.
struct Notch {
  double middle, halfWidth, depth;
};

/// The sheets of a wedge, above and below an edge along the x axis with notches in it.
Facets wedge(const std::vector<Notch>& notches) {
  constexpr double kSlope = 0.3;
  Facets facets;
  const auto add = [&](double x, double y, double z) {
    facets.vertices.push_back({x, y, z});
    return static_cast<std::uint32_t>(facets.vertices.size() - 1);
  };
  std::vector<std::uint32_t> above{add(0, 0, 0)}, below = above;
  for (const auto& [middle, halfWidth, depth] : notches) {
    const std::uint32_t first = add(middle - halfWidth, 0, 0), top = add(middle, -depth, 0);
    const std::uint32_t bottom = add(middle, -depth, -kSlope * depth);
    const std::uint32_t last = add(middle + halfWidth, 0, 0);
    above.insert(above.end(), {first, top, last});
    below.insert(below.end(), {first, bottom, last});
    facets.triangles.push_back({first, top, bottom});
    facets.triangles.push_back({top, last, bottom});
  }
  above.push_back(add(1, 0, 0));
  below.push_back(above.back());
  const std::uint32_t upper = add(0, -1, 0), lower = add(0, -1, -kSlope);
  for (std::size_t i = 1; i < above.size(); ++i) {
    facets.triangles.push_back({upper, above[i], above[i - 1]});
    facets.triangles.push_back({lower, below[i - 1], below[i]});
  }
  facets.triangles.push_back({upper, add(1, -1, 0), above.back()});
  facets.triangles.push_back({lower, below.back(), add(1, -1, -kSlope)});
  return facets;
}

std::size_t patchesOf(const Notch& notch) {
  return findPatches(wedge({notch}), testing::limitsFor(1)).patches.size();
}

TEST(FeatureEdges, SeparatePatchesAlsoWhereASpeckIsBetween) {
  EXPECT_EQ(findPatches(wedge({}), testing::limitsFor(1)).patches.size(), 2u);
  EXPECT_EQ(patchesOf({0.5, 0.01, 0.01}), 2u);
}

TEST(FeatureEdges, AreNoneAroundSliversThatAreLongerThanASpeck) {
  EXPECT_EQ(patchesOf({0.4, 0.2, 0.01}), 2u);
  EXPECT_EQ(patchesOf({0.5, 0.4, 0.2}), 4u) << "too large";
}

TEST(FeatureEdges, GiveTrianglesThatDoNotCountTheNormalsBesideThem) {
  const PatchedFacets patched = findPatches(wedge({{0.5, 0.01, 0.01}}), testing::limitsFor(1));
  for (const Patch& patch : patched.patches)
    for (const std::uint32_t t : patch.triangles)
      EXPECT_LT(distance(patched.normals[t], patched.normals[patch.triangles.back()]), 1e-9) << t;
}

TEST(FeatureEdges, AreKeptWhereAMeshShowsNoneOfTheNoiseBesideThem) {
  std::vector<Notch> notches;
  for (double x = 0.05; x < 0.9; x += 0.07) notches.push_back({x, 0.003, 0.003});
  const ModelMesh mesh = testing::completeMesh(wedge(notches), 0.1);
  EXPECT_EQ(mesh.faces.size(), 2u);
  EXPECT_LT(mesh.elements.size(), 700u);
  EXPECT_GT(measureQuality(mesh).min, 0.5);
}

/// A sheet of two parts, the border of which has a spike: its middle triangle is of the lower part.
Facets spike(double width, double height) {
  Facets facets;
  facets.vertices = {{0, 0, 0},
                     {0.5 - width / 2, 0, 0},
                     {0.5 + width / 2, 0, 0},
                     {1, 0, 0},
                     {0.5, height, 0},
                     {0, -1, 0},
                     {1, -1, 0},
                     {0, 1, 0},
                     {1, 1, 0}};
  facets.triangles = {{5, 1, 0}, {5, 2, 1}, {5, 6, 2}, {6, 3, 2}, {1, 2, 4},
                      {0, 1, 7}, {1, 4, 7}, {4, 8, 7}, {4, 2, 8}, {2, 3, 8}};
  facets.group = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1};
  facets.groupNames = {"lower", "upper"};
  return facets;
}

bool hasSpike(double width, double height) {
  constexpr std::uint32_t kTip = 4;
  const PatchedFacets patched = findPatches(spike(width, height), testing::limitsFor(1));
  EXPECT_EQ(patched.patches.size(), 2u);
  return std::ranges::any_of(patched.curves, [=](const FeatureCurve& curve) {
    return std::ranges::find(curve, kTip) != curve.end();
  });
}

TEST(FeatureEdges, DoNotTurnBackWithinWhatCannotBeSeen) {
  EXPECT_FALSE(hasSpike(0.01, 0.1));
  EXPECT_TRUE(hasSpike(0.1, 0.5)) << "it can be seen";
  EXPECT_TRUE(hasSpike(0.05, 0.02)) << "it is blunt";
}

}  // namespace
}  // namespace af2::geometry
