// Triangles of a file that look to different sides of their surface.
#include <gtest/gtest.h>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include "geometry/faceted/facets.h"
#include "tests/geometry/faceted/faceted_mesh.h"
#include "tests/support/model_mesh.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

using std::numbers::pi;

Facets read(const std::string& obj) {
  return readFacets(testing::TestFile("model.obj", obj).path());
}

/// A Moebius strip: a ladder of squares around the origin that turns by half a turn.
std::string moebiusStrip() {
  constexpr int kRungs = 24;
  std::ostringstream text;
  for (int i = 0; i < kRungs; ++i)
    for (const double half : {-1., 1.}) {
      const double turn = 2 * pi * i / kRungs, radius = 3 + half * std::cos(turn / 2);
      text << "v " << radius * std::cos(turn) << " " << radius * std::sin(turn) << " "
           << half * std::sin(turn / 2) << "\n";
    }
  for (int i = 0; i < kRungs; ++i) {
    const int low = 2 * i + 1, high = low + 1, isLast = i + 1 == kRungs;
    const int nextLow = isLast ? 2 : low + 2, nextHigh = isLast ? 1 : high + 2;
    text << "f " << low << " " << nextLow << " " << nextHigh << "\nf " << low << " " << nextHigh
         << " " << high << "\n";
  }
  return text.str();
}

TEST(Orientations, OfASurfaceWithOneSideAreKept) {
  const Facets strip = read(moebiusStrip());
  ASSERT_EQ(strip.notes.size(), 2u);  // and the edge of the strip
  EXPECT_EQ(strip.notes[0].find("1 edges are kept between triangles of opposite"), 0u);
  EXPECT_NEAR(testing::areaOf(testing::completeMesh(strip, 0.3)), 2 * pi * 3 * 2, 1);
}

TEST(Orientations, OfSheetsWithTrianglesOnBothSidesAreTurned) {
  // Three squares in a row. The second side of the first one and of the middle one is superfluous,
  // because it ends at the last one, and what comes first in the file looks to different sides.
  const Facets sheet = read(
      "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\n"
      "f 1 2 6\nf 1 6 5\nf 6 2 1\nf 5 6 1\nf 7 3 2\nf 6 7 2\nf 2 3 7\nf 2 7 6\n"
      "f 3 4 8\nf 3 8 7\n");
  EXPECT_EQ(sheet.triangles.size(), 6u);
  const ModelMesh result = testing::completeMesh(sheet, 0.3);
  EXPECT_EQ(result.faces.size(), 1u);
  EXPECT_NEAR(testing::areaOf(result), 3, 1e-12);
}

}  // namespace
}  // namespace af2::geometry
