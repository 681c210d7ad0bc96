#include <gtest/gtest.h>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>

#include <algorithm>
#include <map>
#include <set>

#include "geometry/mesh/fingerprint.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/geometry/occ/run/dirt.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

int oddLoopsOf(const ModelMesh& mesh) {
  int odd = 0;
  for (const FaceReport& face : mesh.faces) odd += static_cast<int>(face.oddLoops.size());
  return odd;
}

ModelMesh evenMesh(const Model& model, MeshingOptions options) {
  options.evenLoops = true;
  return mesh(model, options);
}

/// Faces whose elements have an odd number of sides without an element of the same face beyond.
std::set<int> facesWithOddBoundary(const ModelMesh& mesh) {
  std::map<int, std::map<std::pair<VertexId, VertexId>, int>> sides;
  for (std::size_t i = 0; i < mesh.elements.size(); ++i) {
    const auto corners = mesh.elements[i].vertices();
    for (std::size_t k = 0; k < corners.size(); ++k)
      ++sides[mesh.face[i]][std::minmax(corners[k], corners[(k + 1) % corners.size()])];
  }
  std::set<int> odd;
  for (const auto& [face, uses] : sides)
    if (std::ranges::count_if(uses, [](const auto& side) { return side.second == 1; }) % 2 == 1)
      odd.insert(face);
  return odd;
}

std::map<int, int> numbersByEdge(const ModelMesh& mesh) {
  std::map<int, int> segments;
  for (const EdgeSegment& segment : mesh.segments) ++segments[segment.edge];
  return segments;
}

/// All loops are even. No number of segments is off by more than one from what sizes ask for, or
/// has a quarter more on a side of a strip. Retries ask for other sizes where faces came out poor,
/// so numbers are compared without them.
void expectEven(const Model& model, MeshingOptions options) {
  const ModelMesh even = evenMesh(model, options);
  testing::expectComplete(even);
  EXPECT_EQ(oddLoopsOf(even), 0);
  EXPECT_TRUE(facesWithOddBoundary(even).empty());
  options.mostRetries = 0;
  const ModelMesh without = mesh(model, options), first = evenMesh(model, options);
  EXPECT_EQ(oddLoopsOf(first), 0);
  std::map<int, int> before = numbersByEdge(without);
  for (const auto& [edge, number] : numbersByEdge(first)) {
    if (!before.contains(edge)) continue;  // its faces failed there
    EXPECT_LE(number, 1.25 * before[edge] + 1) << "edge " << edge;
    EXPECT_GE(number, before[edge] - 1) << "edge " << edge;
  }
}

/// Two of its faces are trapezoids; rectangles have even loops anyway.
Model wedge() { return testing::modelOf(BRepPrimAPI_MakeWedge(2, 1.3, 1.7, 0.9).Shape()); }

TEST(EvenLoopsOfModels, AreMadeOnAWedge) {
  const Model model = wedge();
  int odd = 0;
  for (const double size : {0.2, 0.3, 0.45, 0.7, 1.5}) {
    SCOPED_TRACE(size);
    expectEven(model, testing::ofSize(size));
    odd += oddLoopsOf(mesh(model, size));
  }
  EXPECT_GT(odd, 0) << "without the option";
}

TEST(EvenLoopsOfModels, AreMadeWithSeamsAndPoles) {
  for (const double size : {0.21, 0.3, 0.5, 1.0}) {
    SCOPED_TRACE(size);
    expectEven(testing::cylinder(1, 2), testing::ofSize(size));
    expectEven(testing::cone(1, 0, 2), testing::ofSize(size));
    expectEven(testing::cone(1, 0.5, 2), testing::ofSize(size));
    expectEven(testing::sphere(1), testing::ofSize(size));
    expectEven(testing::torus(2, 0.6), testing::ofSize(size));
  }
}

TEST(EvenLoopsOfModels, AreMadeOnTheExamples) {
  for (const char* name : {"brickhole.step", "cylinder.step", "die.step", "die.brep"}) {
    const Model model = readModel(std::filesystem::path(AF2_SOURCE_DIR "/examples/models") / name);
    for (const double share : {0.02, 0.025, 0.04, 0.1}) {
      SCOPED_TRACE(name + std::string(" ") + std::to_string(share));
      expectEven(model, testing::ofSize(share * model.diagonal()));
    }
  }
}

TEST(EvenLoopsOfModels, KeepTheElementsOfTurns) {
  const Model model = testing::cylinder(1, 2);
  MeshingOptions options = testing::ofSize(1);
  options.sizes.elementsPerTurn = 17;
  std::map<int, int> before = numbersByEdge(mesh(model, options));
  const ModelMesh even = evenMesh(model, options);
  EXPECT_EQ(oddLoopsOf(even), 0);
  int circles = 0;
  for (const auto& [edge, segments] : numbersByEdge(even)) {
    EXPECT_GE(segments, before[edge]) << "edge " << edge;
    circles += segments == 18;
  }
  EXPECT_EQ(circles, 2);
}

TEST(EvenLoopsOfModels, KeepGivenDivisions) {
  const Model box = testing::box(1, 1, 1);
  MeshingOptions options = testing::ofSize(0.5);
  options.edgePoints[1] = {};
  const ModelMesh even = evenMesh(box, options);
  testing::expectComplete(even);
  EXPECT_EQ(oddLoopsOf(even), 0);
  EXPECT_EQ(numbersByEdge(even)[1], 1);
  for (int edge = 2; edge <= 12; ++edge) {
    options.edgePoints[edge] = {};
  }
  const auto [from, to] = testing::endsOf(box, 2);
  options.edgePoints[2] = {0.5 * (from + to)};
  const ModelMesh odd = evenMesh(box, options);
  testing::expectComplete(odd);
  EXPECT_EQ(oddLoopsOf(odd), 2) << "nothing may change";
  EXPECT_EQ(oddLoopsOf(odd), oddLoopsOf(mesh(box, options)));
}

TEST(EvenLoopsOfModels, DoNotDependOnTheFacesAskedForOrOnThreads) {
  const Model model = wedge();
  int odd = 0;
  for (const double size : {0.2, 0.3, 0.45, 0.7}) {
    MeshingOptions options = testing::ofSize(size);
    odd += oddLoopsOf(mesh(model, options));
    const ModelMesh all = evenMesh(model, options);
    options.threads = 2;
    EXPECT_EQ(fingerprint(evenMesh(model, options)), fingerprint(all));
    options.faces = {3};
    const std::map<int, int> numbers = numbersByEdge(evenMesh(model, options));
    std::map<int, int> ofAll = numbersByEdge(all);
    EXPECT_EQ(numbers.size(), 4u);
    for (const auto& [edge, number] : numbers) EXPECT_EQ(number, ofAll[edge]) << "edge " << edge;
  }
  EXPECT_GT(odd, 0) << "or else nothing had to change";
}

/// The side of a truncated cone, one element wide.
TEST(EvenLoopsOfModels, GiveTheSidesOfStripsEqualNumbers) {
  const Model model = testing::modelOf(BRepPrimAPI_MakeCone(1, 0.88, 0.15).Shape());
  const MeshingOptions options = testing::ofSize(0.17);
  const auto areEqual = [](const ModelMesh& mesh) {
    std::set<int> numbers;
    for (const auto& [edge, number] : numbersByEdge(mesh))
      if (number > 1) numbers.insert(number);  // the seam has one
    return numbers.size() == 1;
  };
  EXPECT_FALSE(areEqual(mesh(model, options)));
  const ModelMesh even = evenMesh(model, options);
  testing::expectComplete(even);
  EXPECT_TRUE(areEqual(even));
}

}  // namespace
}  // namespace af2::geometry
