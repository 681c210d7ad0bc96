// Patches that no front can fill whole, and what is said of those that cross each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "geometry/faceted/cones.h"
#include "geometry/faceted/crossed_facets.h"
#include "geometry/mesh/quality.h"
#include "tests/geometry/faceted/faceted_mesh.h"
#include "tests/geometry/faceted/sheets.h"

namespace af2::geometry {
namespace {

using std::numbers::pi;

MeshingOptions withoutFeatures(double size) {
  MeshingOptions options;
  options.sizes.size = size;
  options.featureAngle = 179;
  return options;
}

bool hasNoteOnPieces(const ModelMesh& mesh) {
  return std::ranges::any_of(mesh.notes, [](const std::string& note) {
    return note.find("cut into pieces") != note.npos;
  });
}

/// Every other vertex of a sphere lies far inside it.
Facets spikyBall() {
  constexpr std::uint32_t kRows = 6, kColumns = 8;
  Facets ball;
  ball.vertices = {{0, 0, 1}, {0, 0, -1}};
  for (std::uint32_t i = 1; i < kRows; ++i)
    for (std::uint32_t j = 0; j < kColumns; ++j) {
      const double r = (i + j) % 2 == 1 ? 1 : 0.4, theta = pi * i / kRows;
      const double phi = 2 * pi * j / kColumns;
      ball.vertices.push_back({r * std::sin(theta) * std::cos(phi),
                               r * std::sin(theta) * std::sin(phi), r * std::cos(theta)});
    }
  const auto at = [](std::uint32_t i, std::uint32_t j) {
    return 2 + (i - 1) * kColumns + j % kColumns;
  };
  for (std::uint32_t j = 0; j < kColumns; ++j) {
    ball.triangles.push_back({0, at(1, j), at(1, j + 1)});
    ball.triangles.push_back({1, at(kRows - 1, j + 1), at(kRows - 1, j)});
  }
  for (std::uint32_t i = 1; i + 1 < kRows; ++i)
    for (std::uint32_t j = 0; j < kColumns; ++j) {
      const std::uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
      if ((i + j) % 2 == 1)
        ball.triangles.insert(ball.triangles.end(), {{a, b, d}, {b, c, d}});
      else
        ball.triangles.insert(ball.triangles.end(), {{a, b, c}, {a, c, d}});
    }
  return ball;
}

/// Two wavy sheets that meet along their borders, in between thinner than elements can follow.
Facets leaf() {
  constexpr std::uint32_t kCells = 12;
  constexpr double kThickness = 0.01, kWave = 0.2;
  Facets leaf;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> known;
  const auto vertex = [&](std::uint32_t i, std::uint32_t j, std::uint32_t side) {
    const bool isOnBorder = i % kCells == 0 || j % kCells == 0;
    const double x = 1.0 * i / kCells, y = 1.0 * j / kCells;
    const double z = kWave * std::sin(5 * pi * x) * std::sin(4 * pi * y);
    const double off = isOnBorder ? 0 : side == 0 ? kThickness : -kThickness;
    const auto [found, isNew] = known.try_emplace({i, j, isOnBorder ? 0 : side},
                                                  static_cast<std::uint32_t>(leaf.vertices.size()));
    if (isNew) leaf.vertices.push_back({x, y, z + off});
    return found->second;
  };
  for (const std::uint32_t side : {0u, 1u})
    for (std::uint32_t i = 0; i < kCells; ++i)
      for (std::uint32_t j = 0; j < kCells; ++j) {
        const auto a = vertex(i, j, side), b = vertex(i + 1, j, side),
                   c = vertex(i + 1, j + 1, side), d = vertex(i, j + 1, side);
        // No triangle has only corners on the border: both sheets would have it.
        const bool turns = (i == 0) != (j == 0) && (i + 1 == kCells) != (j + 1 == kCells);
        std::array<std::array<std::uint32_t, 3>, 2> pair{{{a, b, c}, {a, c, d}}};
        if (turns) pair = {{{a, b, d}, {b, c, d}}};
        for (auto& t : pair) {
          if (side == 1) std::swap(t[0], t[1]);
          leaf.triangles.push_back(t);
        }
      }
  return leaf;
}

/// A strip along a curve that crosses itself at x = y = 0, which its middle does not.
Facets strip() {
  constexpr std::uint32_t kAlong = 40, kAcross = 4;
  return testing::grid(kAlong, kAcross, testing::Closed::InNeither,
                       [](std::uint32_t i, std::uint32_t j) {
                         const double t = 2.6 * (i + 0.25) / kAlong - 1.3;
                         return Point3{t * t - 1, t * (t * t - 1), 0.25 * j / kAcross};
                       });
}

TEST(FacetPieces, HaveBetterElementsThanThoseThatTiltAgainstTheSurface) {
  const ModelMesh mesh = testing::completeMesh(spikyBall(), withoutFeatures(0.5));
  EXPECT_TRUE(hasNoteOnPieces(mesh));
  EXPECT_EQ(testing::eulerNumber(mesh), 2);
  const MeshQuality quality = measureQuality(mesh);
  EXPECT_GT(quality.mean, 0.85);
  EXPECT_GT(quality.min, 0.4);
}

TEST(FacetPieces, AreAsSmallAsTheTrianglesWhereNothingElseCanBeMeshed) {
  MeshingOptions options;
  options.sizes.size = 0.1;
  const Facets thin = leaf();
  const ModelMesh mesh = testing::completeMesh(thin, options);
  EXPECT_TRUE(hasNoteOnPieces(mesh));
  EXPECT_EQ(testing::eulerNumber(mesh), 2);
  EXPECT_EQ(measureQuality(mesh).freeEdges, 0u);
  EXPECT_GT(mesh.faces.size(), thin.triangles.size() / 4);
}

TEST(FacetPieces, ThatFailBecauseTheModelCrossesItselfSaySo) {
  static const AF2Algorithm algorithm(testing::triangleSet());
  MeshingOptions options;
  options.sizes.size = 0.1;
  const ModelMesh mesh = meshFaceted(strip(), algorithm, options);
  int failed = 0;
  for (const FaceReport& face : mesh.faces) {
    if (face.status != FaceStatus::Failed) continue;
    ++failed;
    EXPECT_EQ(face.cause, FailureCause::Model);
    EXPECT_NE(face.reason.find("in the model itself it crosses"), std::string::npos) << face.reason;
  }
  EXPECT_GT(failed, 0);
  EXPECT_GT(mesh.elements.size(), 100u) << "the other pieces have meshes";
}

/// They have no direction, so that they are in no cone.
TEST(FacetPieces, MayHaveTrianglesWithoutArea) {
  PatchedFacets line;
  line.facets.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  line.facets.triangles = {{0, 1, 2}, {0, 2, 3}};
  line.normals.resize(2);
  Patch patch;
  patch.triangles = {0, 1};
  EXPECT_LE(coneBorders(line, patch, pi / 4, 1).size(), 1u);
  EXPECT_LE(coneBorders(line, patch, pi / 4, 0).size(), 1u);
}

TEST(FacetPieces, AreNotTriedWithStrictRules) {
  static const AF2Algorithm algorithm(testing::triangleSet());
  MeshingOptions options;
  options.sizes.size = 0.1;
  options.strictRules = true;
  const ModelMesh mesh = meshFaceted(leaf(), algorithm, options);
  EXPECT_FALSE(hasNoteOnPieces(mesh));
  EXPECT_LT(mesh.faces.size(), 10u);
}

/// What crosses is known by the numbers of triangles.
TEST(CrossedFacets, AreSharedByCutsUnlessTheyChangeTheTriangles) {
  const PatchedFacets open = findPatches(strip(), testing::limitsFor(0.1));
  EXPECT_EQ(cutPatches(open, {}, testing::limitsFor(0.1)).crossed, open.crossed);
  constexpr double kAnyTurn = 1e-3;
  const PatchedFacets creased = findPatches(spikyBall(), {kAnyTurn});
  const PatchedFacets smooth = cutPatches(creased, {}, {179 * pi / 180});
  ASSERT_GT(smooth.facets.triangles.size(), creased.facets.triangles.size())
      << "a closed surface is cut in two by a plane";
  EXPECT_NE(smooth.crossed, creased.crossed);
}

TEST(CrossedFacets, AreFoundWithTheirPlaces) {
  const Facets facets = strip();
  CrossedFacets crossed;
  const auto& crossings = crossed.of(facets);
  EXPECT_GE(crossings.size(), 4u);
  EXPECT_EQ(&crossed.of(facets), &crossings);
  for (const FacetsCross& crossing : crossings) {
    EXPECT_LT(std::hypot(crossing.place.x, crossing.place.y), 0.2);
    EXPECT_LT(crossing.triangles[0] + 8, crossing.triangles[1]) << "neighbours do not cross";
  }
  CrossedFacets ofBall;
  EXPECT_TRUE(ofBall.of(spikyBall()).empty());
}

}  // namespace
}  // namespace af2::geometry
