#include "cli/meshing/mesh_summary.h"

#include <gtest/gtest.h>

namespace af2::cli {
namespace {

using geometry::FaceReport;
using geometry::FaceStatus;
using geometry::ModelMesh;

TEST(Grouped, PutsSpacesBetweenThousands) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1000), "1 000");
  EXPECT_EQ(grouped(1234567), "1 234 567");
}

TEST(FailureText, NamesEachFailedFaceWithItsReason) {
  ModelMesh mesh;
  mesh.faces = {{1, "", "plane", "", FaceStatus::Complete, 2, 0, 1, ""},
                {2, "inlet", "cylinder", "", FaceStatus::Failed, 0, 0, 1, "stuck at (1, 2, 3)"}};
  EXPECT_EQ(failureText(mesh), "af2: face 2 \"inlet\" (cylinder) failed: stuck at (1, 2, 3)\n");
  mesh.faces.pop_back();
  EXPECT_EQ(failureText(mesh), "");
}

TEST(SummaryText, DoesNotCountSkippedFaces) {
  ModelMesh mesh;
  mesh.faces = {{1, "", "plane", "", FaceStatus::Complete, 2, 0, 1, ""},
                {2, "", "plane", "", FaceStatus::Skipped, 0, 0, 1, ""}};
  EXPECT_EQ(summaryText(mesh, {}).substr(0, 11), "faces 1/1  ");
}

TEST(SummaryText, TellsWhetherTheMeshIsClosedAndWhereItIsWorst) {
  ModelMesh mesh;
  mesh.faces = {{1, "", "plane", "", FaceStatus::Complete, 2, 0, 1, ""}};
  mesh.vertices.resize(3);
  mesh.elements.resize(1);
  geometry::MeshQuality quality;
  quality.worstFace = 5;
  quality.worstPlace = {1.23456, 2, 3};
  EXPECT_NE(summaryText(mesh, quality).find("1 triangles  closed\n"), std::string::npos);
  EXPECT_NE(summaryText(mesh, quality).find("min 0.000 (face 5 at (1.23, 2, 3))"),
            std::string::npos);
  quality.freeEdges = 1234;
  EXPECT_NE(summaryText(mesh, quality).find("open, 1 234 free edges\n"), std::string::npos);
}

TEST(SummaryText, TellsNoQualityOfAMeshWithoutElements) {
  EXPECT_EQ(summaryText({}, {}).find("quality"), std::string::npos);
}

TEST(UnitText, TellsOfFilesThatAreNotInMillimetres) {
  ModelMesh mesh;
  EXPECT_EQ(unitText(mesh), "");
  mesh.unit = "mm";
  EXPECT_EQ(unitText(mesh), "");
  for (const char* unit : {"millimetre", "MM", "MILLIMETRE"}) {
    mesh.fileUnit = unit;
    EXPECT_EQ(unitText(mesh), "") << unit;
  }
  mesh.fileUnit = "INCH";
  EXPECT_EQ(unitText(mesh),
            "note: lengths in the file are in INCH; here, sizes and coordinates are in mm\n");
}

}  // namespace
}  // namespace af2::cli
