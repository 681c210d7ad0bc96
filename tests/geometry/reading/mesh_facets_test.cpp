// Mesh files as surfaces to be meshed.
#include <gtest/gtest.h>

#include "engine/base/error.h"
#include "geometry/faceted/facets.h"
#include "geometry/io/mesh_files.h"
#include "tests/support/small_meshes.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

Facets facetsOf(const std::string& name, const std::string& text) {
  return readFacets(testing::TestFile(name, text).path());
}

std::string faultOfFacets(const std::string& name, const std::string& text) {
  try {
    facetsOf(name, text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const std::string kCubeOff =
    "OFF # a cube\n8 6 12\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n4 0 3 2 1\n"
    "4 4 5 6 7 255 0 0\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

TEST(MeshFacets, KeepTheFacesOfAMeshAsParts) {
  const ModelMesh cube = cubeMesh();
  const testing::TestFolder folder;
  for (const char* const extension : {".msh", ".msh2", ".vtu", ".vtk"}) {
    const auto path = folder / (std::string("cube") + extension);
    writeMesh(cube, path);
    const Facets facets = readFacets(path);
    EXPECT_EQ(facets.vertices.size(), 8u) << extension;
    EXPECT_EQ(facets.triangles.size(), 12u) << extension;  // the quadrilateral is split
    ASSERT_EQ(facets.groupNames.size(), 6u) << extension;
    EXPECT_NE(facets.group.front(), facets.group.back()) << extension;
    const bool hasNames = std::string(extension) != ".vtk";
    EXPECT_EQ(facets.groupNames[5], hasNames ? "lid" : "") << extension;
    EXPECT_EQ(facets.groupNames[0], "") << extension;
  }
}

TEST(MeshFacets, AreOfPlyAndOffFiles) {
  const testing::TestFile ply("cube.ply");
  writeMesh(cubeMesh(), ply.path());
  EXPECT_EQ(readFacets(ply.path()).triangles.size(), 12u);
  const Facets facets = facetsOf("cube.off", kCubeOff);
  EXPECT_EQ(facets.vertices.size(), 8u);
  EXPECT_EQ(facets.triangles.size(), 12u);
}

/// The first polygon is an L, whose corners cannot be joined to a fan.
TEST(MeshFacets, DividePolygonsIntoTriangles) {
  const std::string points = "0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n";
  const Facets facets = facetsOf("l.off", "OFF\n6 2 0\n" + points + "6 3 4 5 0 1 2\n3 2 4 3\n");
  ASSERT_EQ(facets.triangles.size(), 5u);
  double area = 0;
  for (const auto& [a, b, c] : facets.triangles) {
    const Point3 normal =
        cross(facets.vertices[b] - facets.vertices[a], facets.vertices[c] - facets.vertices[a]);
    EXPECT_GT(normal.z, 0);
    area += normal.z / 2;
  }
  EXPECT_DOUBLE_EQ(area, 3.5);
  ASSERT_FALSE(facets.notes.empty());
  EXPECT_EQ(facets.notes[0], "divided into triangles: 1 polygon with more than four corners");
  EXPECT_NE(faultOfFacets("wrong.off", "OFF\n6 1 0\n" + points + "6 3 4 5 0 1 9\n")
                .find("polygon 0 (counted from 0) uses a vertex that the file does not have"),
            std::string::npos);
}

TEST(MeshFacets, TellWhatIsWrongWithAFile) {
  EXPECT_NE(faultOfFacets("empty.off", "").find("is truncated: the head is missing"),
            std::string::npos);
  EXPECT_NE(faultOfFacets("cut.off", kCubeOff.substr(0, 57)).find("is truncated"),
            std::string::npos);
  EXPECT_NE(faultOfFacets("other.off", "ply\n3 1 0\n").find("does not begin with OFF"),
            std::string::npos);
  EXPECT_NE(faultOfFacets("word.off", "OFF\n1 1 0\n0 0 x\n").find("line 3: 'x' is not a number"),
            std::string::npos);
  EXPECT_NE(faultOfFacets("many.off", "OFF\n99999 1 0\n").find("too short for 99999"),
            std::string::npos);
  EXPECT_NE(faultOfFacets("vertex.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n")
                .find("uses a vertex that the file does not have"),
            std::string::npos);
}

}  // namespace
}  // namespace af2::geometry
