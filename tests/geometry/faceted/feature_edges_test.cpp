// Noise along feature edges, as triangulations of CAD surfaces have it: triangles far smaller than
// an element, which look anywhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
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

TEST(FeatureEdges, AreKeptAroundNarrowParts) {
  Facets facets = wedge({{0.4, 0.2, 0.01}});
  facets.groupNames = {"notch", "sheets"};
  facets.group.assign(facets.triangles.size(), 1);
  facets.group[0] = facets.group[1] = 0;
  EXPECT_EQ(findPatches(std::move(facets), testing::limitsFor(1)).patches.size(), 3u);
}

/// A step far lower than an element is no face, however long.
TEST(FeatureEdges, AreOneAtALowStep) {
  const auto step = [](double height) {
    Facets facets = testing::grid(1, 3, testing::Closed::InNeither, [&](auto i, auto j) {
      return Point3{1.0 * i, j < 2 ? 1.0 * j : j - 1.0, j < 2 ? 0 : height};
    });
    return findPatches(std::move(facets), testing::limitsFor(1)).patches.size();
  };
  EXPECT_EQ(step(0.004), 2u);
  EXPECT_EQ(step(0.02), 3u) << "it can be seen";
}

/// Both long sides of the rim of a thin wall are edges.
TEST(FeatureEdges, AreKeptAroundRims) {
  const auto rim = [](double width) {
    Facets facets = testing::grid(1, 3, testing::Closed::InNeither, [&](auto i, auto j) {
      const double y = j == 0 || j == 3 ? 1 : 0;
      return Point3{1.0 * i, j < 2 ? 0 : width, y};
    });
    return findPatches(std::move(facets), testing::limitsFor(1)).patches.size();
  };
  EXPECT_EQ(rim(0.004), 3u);
  EXPECT_EQ(rim(0.0001), 2u) << "too thin even for a rim";
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

/// A sheet of two parts. Their border goes along the x axis to `from`, from there to the tip of a
/// triangle of the lower part, from there to `to`, and on along the axis.
bool hasTip(double from, double to, const Point3& tip) {
  constexpr std::uint32_t kTip = 4;
  Facets facets;
  facets.vertices = {{0, 0, 0},  {from, 0, 0}, {to, 0, 0}, {1, 0, 0}, tip,
                     {0, -1, 0}, {1, -1, 0},   {0, 1, 0},  {1, 1, 0}};
  facets.triangles = {{5, 1, 0}, {5, 2, 1}, {5, 6, 2}, {6, 3, 2}, {1, 2, 4},
                      {0, 1, 4}, {0, 4, 7}, {4, 8, 7}, {4, 2, 8}, {2, 3, 8}};
  facets.group = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1};
  facets.groupNames = {"lower", "upper"};
  const PatchedFacets patched = findPatches(std::move(facets), testing::limitsFor(1));
  EXPECT_EQ(patched.patches.size(), 2u);
  return std::ranges::any_of(patched.curves, [=](const FeatureCurve& curve) {
    return std::ranges::find(curve, kTip) != curve.end();
  });
}

TEST(FeatureEdges, DoNotTurnBackWithinWhatCannotBeSeen) {
  EXPECT_FALSE(hasTip(0.5, 0.55, {0.47, 0.002, 0}));
  EXPECT_FALSE(hasTip(0.5, 0.508, {0.504, 0.1, 0}));
  EXPECT_TRUE(hasTip(0.5, 0.54, {0.52, 0.1, 0})) << "it can be seen";
  EXPECT_TRUE(hasTip(0.5, 0.55, {0.5, 0.0005, 0})) << "it is blunt";
}

/// A part in a sheet that is narrow throughout, and that ends in a tip.
TEST(FeatureEdges, TurnBackAtTheTipsOfPatches) {
  Facets facets;
  facets.vertices = {{0, 0, 0},  {0.1, -0.004, 0}, {0.1, 0.004, 0}, {1, -0.04, 0}, {1, 0.04, 0},
                     {0, -1, 0}, {1, -1, 0},       {0, 1, 0},       {1, 1, 0},     {-1, 0, 0}};
  facets.triangles = {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {0, 5, 1}, {5, 6, 1}, {6, 3, 1},
                      {0, 2, 7}, {2, 8, 7}, {2, 4, 8}, {9, 5, 0}, {9, 0, 7}};
  facets.group = {0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1};
  facets.groupNames = {"wedge", "sheet"};
  const PatchedFacets patched = findPatches(std::move(facets), testing::limitsFor(1));
  ASSERT_EQ(patched.patches.size(), 2u);
  EXPECT_EQ(patched.patches[0].triangles.size(), 3u);
}

}  // namespace
}  // namespace af2::geometry
