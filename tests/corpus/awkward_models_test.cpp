// The families of made/awkward.cpp, some models of each: what their meshes must be.
#include <gtest/gtest.h>

#include <BRepCheck_Analyzer.hxx>
#include <string>

#include "geometry/mesh/quality.h"
#include "tests/corpus/made/families.h"
#include "tests/geometry/occ/meshing.h"
#include "tests/support/model_mesh.h"

namespace af2::geometry {
namespace {

constexpr int kModels = 8;

TopoDS_Shape shapeOf(const std::string& name, int number) {
  for (const made::Family& family : made::awkwardFamilies()) {
    if (name != family.name) continue;
    made::Draw draw(static_cast<std::uint64_t>(1000 + number));
    TopoDS_Shape shape = family.make(draw);
    EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid()) << name << " " << number;
    return shape;
  }
  ADD_FAILURE() << "there is no family " << name;
  return {};
}

/// Calls check(model, number) for each model of a family.
template <class Check>
void forEachModel(const std::string& family, const Check& check) {
  for (int number = 0; number < kModels; ++number) {
    SCOPED_TRACE(family + " " + std::to_string(number));
    check(testing::modelOf(shapeOf(family, number)), number);
  }
}

/// Complete, closed, and with elements that do not cross.
void expectClosed(const ModelMesh& mesh) {
  testing::expectComplete(mesh);
  EXPECT_EQ(measureQuality(mesh).freeEdges, 0u);
  EXPECT_EQ(testing::crossingsOf(mesh), 0u);
}

TEST(AwkwardModels, PinholesKeepThreeSegmentsWhateverTheLeastSize) {
  forEachModel("pinholes", [](const Model& model, int) {
    MeshingOptions options = testing::ofSize(2);
    options.sizes.minSize = 0.5;
    options.sizes.elementsPerTurn = 12;
    const ModelMesh mesh = testing::mesh(model, options);
    expectClosed(mesh);
    EXPECT_EQ(testing::eulerNumber(mesh), -2);  // two holes
  });
}

TEST(AwkwardModels, NeedlesAreMeshedToTheirTips) {
  forEachModel("needle", [](const Model& model, int) {
    const ModelMesh mesh = testing::mesh(model, 0.7);
    expectClosed(mesh);
    EXPECT_EQ(testing::eulerNumber(mesh), 2);
  });
}

TEST(AwkwardModels, SurfacesExtrudedFromHyperbolasAreMeshed) {
  forEachModel("hyperbolic_prism", [](const Model& model, int) {
    const ModelMesh mesh = testing::mesh(model, 0.5);
    expectClosed(mesh);
    double area = 0;
    for (const FaceReport& face : mesh.faces) area += face.area;
    EXPECT_NEAR(testing::areaOf(mesh), area, 0.02 * area);
  });
}

/// A sheet is complete. The walls of a slit in a solid lie on each other, which is told.
TEST(AwkwardModels, SlitsWithoutWidthAreClosedOrTold) {
  forEachModel("hair_slit", [](const Model& model, int) {
    const ModelMesh mesh = testing::mesh(model, 0.6);
    EXPECT_EQ(testing::crossingsOf(mesh), 0u);
    if (model.faceCount() == 1) testing::expectComplete(mesh);
    for (const FaceReport& face : mesh.faces) {
      if (face.status == FaceStatus::Complete)
        EXPECT_NEAR(testing::areaOf(mesh, face.id), face.area, 0.02 * face.area) << face.id;
      else
        EXPECT_NE(face.reason.find("elements lie on those of face"), std::string::npos)
            << face.reason;
    }
  });
}

TEST(AwkwardModels, FoldedSheetsAreMeshedOrRefusedWithAReason) {
  forEachModel("folded_sheet", [](const Model& model, int) {
    const ModelMesh mesh = testing::mesh(model, 0.5);
    ASSERT_EQ(mesh.faces.size(), 1u);
    if (mesh.faces[0].status == FaceStatus::Failed) {
      EXPECT_FALSE(mesh.faces[0].reason.empty());
      return;
    }
    testing::expectComplete(mesh);
    EXPECT_EQ(testing::crossingsOf(mesh), 0u);
    EXPECT_GT(testing::leastAngle(mesh), 0.5);
  });
}

TEST(AwkwardModels, HolesWithinTheTolerancesOfTheirVerticesMakeNoNeedles) {
  forEachModel("fat_vertices", [](const Model& model, int) {
    const ModelMesh mesh = testing::mesh(model, 0.6);
    testing::expectComplete(mesh);
    EXPECT_EQ(testing::crossingsOf(mesh), 0u);
    EXPECT_GT(testing::leastAngle(mesh), 0.5);
  });
}

TEST(AwkwardModels, VerticesInsidePlaneFacesLieInThePlane) {
  forEachModel("beside_the_plane", [](const Model& model, int) {
    const ModelMesh mesh = testing::mesh(model, 0.7);
    testing::expectComplete(mesh);
    std::vector<bool> isOnEdge(mesh.vertices.size(), false);
    for (const EdgeSegment& segment : mesh.segments)
      isOnEdge[segment.from.value] = isOnEdge[segment.to.value] = true;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
      if (!isOnEdge[v]) {
        EXPECT_NEAR(mesh.vertices[v].z, 0, 1.2e-5);  // edges are up to a thousand times as far off
      }
  });
}

}  // namespace
}  // namespace af2::geometry
