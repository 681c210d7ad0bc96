#include "geometry/check/flat_patch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/check/element_crossings.h"
#include "tests/support/element.h"

namespace af2::geometry {
namespace {

using af2::testing::v;

constexpr double kThin = 1e-9;

/// Adds a face of n x n squares of two triangles each, from `origin` along `x` and `y`, with its
/// corner there as a vertex of the mesh if that is not 0, and its boundary as segments.
void addSquares(ModelMesh& mesh, int face, std::size_t n, Point3 origin, Point3 x, Point3 y,
                std::size_t first = 0) {
  const std::size_t begin = mesh.vertices.size(), step = n + 1;
  const double share = 1 / static_cast<double>(n);
  for (std::size_t j = 0; j <= n; ++j)
    for (std::size_t i = 0; i <= n; ++i)
      mesh.vertices.push_back(origin + static_cast<double>(i) * share * x +
                              static_cast<double>(j) * share * y);
  const auto at = [&](std::size_t i, std::size_t j) {
    return first > 0 && i + j == 0 ? v(first) : v(begin + j * step + i);
  };
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      mesh.elements.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1), VertexId()}});
      mesh.elements.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1), VertexId()}});
      mesh.face.insert(mesh.face.end(), 2, face);
    }
  for (std::size_t i = 0; i < n; ++i) {
    mesh.segments.push_back({at(i, 0), at(i + 1, 0), 1, 1});
    mesh.segments.push_back({at(n, i), at(n, i + 1), 1, 1});
    mesh.segments.push_back({at(n - i, n), at(n - i - 1, n), 1, 1});
    mesh.segments.push_back({at(0, n - i), at(0, n - i - 1), 1, 1});
  }
}

/// Two faces of the same squares, the first one in the plane z = 0.
struct TwoFaces {
  ModelMesh mesh;

  TwoFaces(Point3 origin, Point3 x, Point3 y) {
    addSquares(mesh, 1, 4, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    addSquares(mesh, 2, 4, origin, x, y);
  }

  bool areParted() const {
    const PatchOutlines outlines(mesh, kOneByOne);
    const OutlinedPatch one = outlines.patch(0, 32), other = outlines.patch(32, 64);
    const auto flatOne = flatPatchOf(mesh, one, kThin), flatOther = flatPatchOf(mesh, other, kThin);
    if (!flatOne || !flatOther) return false;
    const bool areParted = arePartedByAPlane(mesh, one, *flatOne, other, *flatOther, kThin);
    EXPECT_EQ(arePartedByAPlane(mesh, other, *flatOther, one, *flatOne, kThin), areParted);
    return areParted;
  }
};

/// The second face goes on from a side of the first, at an angle to it.
TwoFaces folded(double angle) {
  return {{1, 0, 0}, {-std::cos(angle), 0, std::sin(angle)}, {0, 1, 0}};
}

TEST(FlatPatch, LiesInAPlaneWhereverThatIs) {
  for (const Point3& x : {Point3{1, 0, 0}, {1, 2, 3}, {-3, 1, 0.1}}) {
    TwoFaces faces({0.1, 0.2, 0.3}, x, {0.3, 0, 1});
    const PatchOutlines outlines(faces.mesh, kOneByOne);
    const OutlinedPatch patch = outlines.patch(32, 64);
    EXPECT_TRUE(flatPatchOf(faces.mesh, patch, kThin));
    faces.mesh.vertices[25 + 12] = faces.mesh.vertices[25 + 12] + Point3{1e-8, -1e-8, 1e-8};
    EXPECT_FALSE(flatPatchOf(faces.mesh, patch, kThin));
    EXPECT_TRUE(flatPatchOf(faces.mesh, patch, 1e-7));
  }
}

TEST(FlatPatch, HasAllElementsOnOneSideUp) {
  TwoFaces faces({0, 0, 1}, {1, 0, 0}, {0, 1, 0});
  faces.mesh.vertices[25 + 6] = {0.6, 0.3, 1};  // beyond its neighbours
  const PatchOutlines outlines(faces.mesh, kOneByOne);
  EXPECT_FALSE(flatPatchOf(faces.mesh, outlines.patch(32, 64), kThin));
}

TEST(FlatPatch, IsPartedFromAnotherThatStandsOnIt) {
  for (const double angle : {0.1, 0.5, 1.57, 2.5, 3.0, -0.1, -1.57})
    EXPECT_TRUE(folded(angle).areParted()) << angle;
  EXPECT_TRUE(TwoFaces({0.25, 0.25, 0}, {0.5, 0, 0}, {0, 0.1, 1}).areParted());
}

/// Such faces may overlap.
TEST(FlatPatch, IsNotPartedFromAnotherInItsPlaneOrNearlySo) {
  for (const double angle : {0., 0.004, -0.004, 0.01}) {
    EXPECT_FALSE(folded(angle).areParted()) << angle;
    EXPECT_FALSE(folded(3.14159 + angle).areParted()) << angle;
  }
}

TEST(FlatPatch, IsNotPartedFromAnotherThatGoesThroughIt) {
  EXPECT_FALSE(TwoFaces({0.2, 0.2, -0.3}, {0.5, 0, 0}, {0, 0.1, 1}).areParted());
  EXPECT_FALSE(TwoFaces({0.2, 0.2, -1e-6}, {0.5, 0, 0}, {0, 0.1, 1}).areParted());
}

/// They hang together at one vertex, so that they are compared.
TEST(FlatPatch, OfOneShellThatGoesThroughAnotherIsFound) {
  ModelMesh mesh;
  addSquares(mesh, 1, 4, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  addSquares(mesh, 2, 4, {1, 1, 0}, {-0.5, -0.5, 0.5}, {0, -1, -0.3}, 24);
  EXPECT_FALSE(elementCrossings(mesh, kOneByOne).empty());
  ModelMesh beside;
  addSquares(beside, 1, 4, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  addSquares(beside, 2, 4, {1, 1, 0}, {-0.5, -0.5, 0.5}, {0, -1, 0.3}, 24);
  EXPECT_TRUE(elementCrossings(beside, kOneByOne).empty());
}

}  // namespace
}  // namespace af2::geometry
