// Meshes of CAD models within a distance from the model.
#include <gtest/gtest.h>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>

#include <cmath>
#include <map>
#include <numbers>

#include "engine/base/error.h"
#include "geometry/mesh/inside_out.h"
#include "geometry/mesh/quality.h"
#include "geometry/occ/run/mesh_model.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

MeshingOptions within(double chord, double size) {
  MeshingOptions options = testing::ofSize(size);
  options.sizes.chords.everywhere = {chord, false};
  return options;
}

MeshingOptions fewestWithin(double chord) {
  MeshingOptions options = within(chord, 1e300);
  options.fewest = true;
  return options;
}

ModelMesh meshed(const Model& model, const MeshingOptions& options) {
  ModelMesh mesh = testing::mesh(model, options);
  testing::expectComplete(mesh);
  EXPECT_TRUE(mesh.findings.empty());
  EXPECT_EQ(measureQuality(mesh).freeEdges, 0u);
  return mesh;
}

/// The largest distance of many points of the triangles from a sphere around the origin.
double farthestFromSphere(const ModelMesh& mesh, double radius) {
  constexpr int kParts = 12;
  double farthest = 0;
  for (const Element& element : mesh.elements) {
    const auto at = [&](std::size_t i) { return mesh.vertices[element.corners[i].value]; };
    for (int i = 0; i <= kParts; ++i)
      for (int j = 0; i + j <= kParts; ++j) {
        const Point3 p =
            1.0 / kParts * (double(i) * at(0) + double(j) * at(1) + double(kParts - i - j) * at(2));
        farthest = std::max(farthest, std::abs(length(p) - radius));
      }
  }
  return farthest;
}

TEST(Chord, HoldsOnSpheresAndElementsGetFewerWithIt) {
  std::size_t before = 0;
  for (const double chord : {0.4, 0.1, 0.025}) {
    const ModelMesh mesh = meshed(testing::sphere(5), within(chord, 10));
    ASSERT_TRUE(mesh.deviation);
    EXPECT_LE(mesh.deviation->largest, chord);
    // Between the points at which AF2 measures, the distance is hardly larger.
    EXPECT_LE(farthestFromSphere(mesh, 5), 1.02 * chord);
    EXPECT_LE(mesh.deviation->largest, farthestFromSphere(mesh, 5) * (1 + 1e-9));
    // The distance is proportional to the square of the lengths: a quarter takes four times as
    // many.
    if (before > 0) {
      EXPECT_NEAR(double(mesh.elements.size()) / double(before), 4, 1.5);
    }
    before = mesh.elements.size();
  }
}

TEST(Chord, HoldsOnEveryFaceOfTheReport) {
  const ModelMesh mesh = meshed(testing::cylinder(5, 10), within(0.05, 10));
  for (const FaceReport& face : mesh.faces) {
    ASSERT_TRUE(face.deviation);
    EXPECT_LE(*face.deviation, 0.05);
  }
}

TEST(Chord, HoldsOnATorusAlsoAsAShareOfTheSize) {
  MeshingOptions options = within(0.02, 2);
  options.sizes.chords.everywhere.isShareOfSize = true;
  const ModelMesh mesh = meshed(testing::modelOf(BRepPrimAPI_MakeTorus(10, 3).Shape()), options);
  EXPECT_LE(mesh.deviation->largest, 0.04);
  EXPECT_GT(mesh.deviation->largest, 0.01);
}

/// OpenCASCADE does not take the profile for closed, a whole circle from 0 to 2 pi: points beyond
/// the seam are near the other end of the parameter.
TEST(Chord, HoldsAcrossASeamThatIsNotSaidToClose) {
  const gp_Circ profile(gp_Ax2({2, 0, 0}, {0, -1, 0}, {0, 0, -1}), 1);
  const TopoDS_Shape disc =
      BRepBuilderAPI_MakeFace(
          BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(profile).Edge()).Wire())
          .Face();
  const TopoDS_Shape ring =
      BRepPrimAPI_MakeRevol(disc, gp_Ax1(gp_Pnt(), gp::DZ()), 2 * std::numbers::pi).Shape();
  const ModelMesh mesh = meshed(testing::modelOf(ring), within(0.01, 0.5));
  ASSERT_TRUE(mesh.deviation);
  EXPECT_LE(mesh.deviation->largest, 0.01);
  EXPECT_LT(mesh.elements.size(), 8000u);
}

TEST(Chord, OfOneFaceLeavesTheOthersAlone) {
  const Model model = testing::modelOf(
      BRepAlgoAPI_Cut(BRepPrimAPI_MakeBox(40, 20, 5).Shape(),
                      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(10, 10, -1), gp::DZ()), 4, 9).Shape())
          .Shape());
  MeshingOptions options = testing::ofSize(5);
  int hole = 0;
  for (int face = 1; face <= model.faceCount(); ++face)
    if (model.surfaceType(face) == "cylinder") hole = face;
  ASSERT_GT(hole, 0);
  const std::size_t without = meshed(model, options).elements.size();
  options.sizes.chords.faces[hole] = {0.01, false};
  const ModelMesh mesh = meshed(model, options);
  EXPECT_GT(mesh.elements.size(), without);
  EXPECT_LE(mesh.faces[static_cast<std::size_t>(hole) - 1].deviation.value_or(1), 0.01);
}

TEST(Chord, ThatTheSmallestSizePreventsIsToldInANote) {
  MeshingOptions options = within(0.001, 4);
  options.sizes.minSize = 2;
  const ModelMesh mesh = testing::mesh(testing::cylinder(5, 10), options);
  ASSERT_FALSE(mesh.notes.empty());
  EXPECT_NE(mesh.notes.back().find("the smallest size"), std::string::npos);
  EXPECT_GT(mesh.deviation->largest, 0.001);
}

TEST(Chord, IsTheSameForAnyNumberOfThreads) {
  MeshingOptions options = fewestWithin(0.05);
  const ModelMesh one = meshed(testing::cylinder(3, 7), options);
  options.threads = 3;
  const ModelMesh three = meshed(testing::cylinder(3, 7), options);
  EXPECT_EQ(one.vertices, three.vertices);
  EXPECT_EQ(one.elements, three.elements);
}

TEST(Fewest, IsTwelveTrianglesForABox) {
  EXPECT_EQ(meshed(testing::box(30, 10, 2), fewestWithin(0.1)).elements.size(), 12u);
}

TEST(Fewest, IsOneRowAroundACylinder) {
  const double radius = 5, chord = 0.05;
  const ModelMesh mesh = meshed(testing::cylinder(radius, 10), fewestWithin(chord));
  EXPECT_LE(mesh.deviation->largest, chord);
  const double around = std::numbers::pi / std::acos(1 - chord / radius);
  // 2 n around, and n - 2 at each end, are the least.
  EXPECT_LT(double(mesh.elements.size()), 2 * (4 * around));
  EXPECT_NEAR(enclosedVolume(mesh).value_or(0), 250 * std::numbers::pi,
              2 * chord * 250 * std::numbers::pi / radius * 2);
}

TEST(Fewest, HoldsOnASphere) {
  const ModelMesh all = meshed(testing::sphere(5), within(0.1, 10));
  const ModelMesh mesh = meshed(testing::sphere(5), fewestWithin(0.1));
  EXPECT_LE(mesh.deviation->largest, 0.1);
  EXPECT_LE(farthestFromSphere(mesh, 5), 0.102);
  EXPECT_LT(mesh.elements.size(), all.elements.size());
}

TEST(Fewest, NeedsABound) {
  MeshingOptions options = testing::ofSize(1);
  options.fewest = true;
  EXPECT_THROW(testing::mesh(testing::box(1, 1, 1), options), InputError);
}

TEST(Volume, ThatIsCutOffIsToldInANote) {
  const auto notesOf = [](double size) {
    return testing::mesh(testing::cylinder(5, 10), size).notes;
  };
  EXPECT_TRUE(notesOf(1).empty());
  ASSERT_EQ(notesOf(1000).size(), 1u);
  EXPECT_NE(notesOf(1000)[0].find("less volume than the model"), std::string::npos);
  EXPECT_TRUE(testing::mesh(testing::box(1, 2, 3), 1000).notes.empty());
}

}  // namespace
}  // namespace af2::geometry
