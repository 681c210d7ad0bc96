#include "geometry/reading/read_mesh.h"

#include <gtest/gtest.h>

#include <fstream>

#include "engine/base/error.h"
#include "geometry/base/words.h"
#include "geometry/io/mesh_files.h"
#include "geometry/mesh/second_order.h"
#include "tests/support/planar_meshes.h"
#include "tests/support/test_folder.h"
#include "tests/support/written.h"

namespace af2::geometry {
namespace {

MeshFile readText(const std::string& name, const std::string& text) {
  return readMesh(testing::TestFile(name, text).path());
}

std::string faultOf(const std::string& name, const std::string& text) {
  try {
    readText(name, text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string cutFile(const std::string& extension) {
  const std::string content = testing::written(cubeMesh(), extension);
  return faultOf("cut" + extension, content.substr(0, content.size() / 2));
}

TEST(ReadMesh, GivesBackWhatWasWritten) {
  const ModelMesh cube = cubeMesh();
  for (const char* const extension : {".vtu", ".vtk", ".msh", ".obj", ".ply"}) {
    const testing::TestFile made(std::string("cube") + extension);
    writeMesh(cube, made.path());
    const MeshFile file = readMesh(made.path());
    ASSERT_EQ(file.mesh.elements.size(), cube.elements.size()) << extension;
    EXPECT_EQ(file.mesh.vertices.size(), cube.vertices.size()) << extension;
    EXPECT_EQ(file.hasFaces, std::string(extension) != ".ply") << extension;
    for (std::size_t e = 0; e < cube.elements.size() && file.hasFaces; ++e) {
      EXPECT_EQ(file.mesh.face[e], cube.face[e]) << extension;
      for (std::size_t i = 0; i < cube.elements[e].vertices().size(); ++i)
        EXPECT_EQ(file.mesh.vertices[file.mesh.elements[e].corners[i].value],
                  cube.vertices[cube.elements[e].corners[i].value])
            << extension;
    }
  }
}

TEST(ReadMesh, JoinsTheTrianglesOfAnStlFile) {
  const testing::TestFile made("cube.stl");
  writeMesh(cubeMesh(), made.path());
  const MeshFile file = readMesh(made.path());
  EXPECT_EQ(file.mesh.elements.size(), 12u);
  EXPECT_EQ(file.mesh.vertices.size(), 8u);
  EXPECT_FALSE(file.hasFaces);
}

TEST(ReadMesh, ReadsLinesAndSizes) {
  ModelMesh mesh = squareGrid(2);
  mesh.wantedSizes.assign(9, 0.5);
  mesh.segments = {{VertexId(0), VertexId(1), 7, 1, {}}};
  const testing::TestFolder folder;
  writeMesh(mesh, folder / "lines.vtu", LinesAlong::AllEdges);
  const MeshFile vtu = readMesh(folder / "lines.vtu");
  EXPECT_EQ(vtu.mesh.wantedSizes, mesh.wantedSizes);
  ASSERT_EQ(vtu.mesh.segments.size(), 1u);
  EXPECT_EQ(vtu.mesh.segments[0].edge, 7);
  for (const char* const name : {"lines.vtk", "lines.msh"}) {
    writeMesh(mesh, folder / name, LinesAlong::AllEdges);
    EXPECT_EQ(readMesh(folder / name).mesh.segments, vtu.mesh.segments) << name;
  }
}

constexpr char kOldMsh[] =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n10 0 0 0\n20 1 0 0\n30 1 1 0\n40 0 1 0\n"
    "$EndNodes\n$Elements\n3\n1 1 2 9 5 10 20\n2 2 2 9 3 10 20 30\n3 2 2 9 4 10 30 40\n"
    "$EndElements\n";

TEST(ReadMesh, ReadsGmsh22) {
  const MeshFile file = readText("old.msh", kOldMsh);
  EXPECT_EQ(file.mesh.face, (std::vector<std::int32_t>{3, 4}));
  EXPECT_EQ(file.mesh.segments.size(), 1u);
  EXPECT_EQ(file.mesh.elements[1].corners[2], VertexId(3));
}

TEST(ReadMesh, ReadsTextForms) {
  EXPECT_EQ(readText("t.ply",
                     "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                     "property float z\nelement face 1\nproperty list uchar int vertex_index\n"
                     "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
                .mesh.vertices[1],
            (Point3{1, 0, 0}));
  EXPECT_EQ(readText("t.vtk",
                     "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                     "POINTS 3 float\n0 0 0 1 0 0 0 1 0\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n")
                .mesh.elements.size(),
            1u);
}

TEST(ReadMesh, IgnoresFacesThatAreNotThoseOfAllCells) {
  const std::string cells = "CELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n";
  const MeshFile file =
      readText("twice.vtk",
               "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
               "POINTS 3 float\n0 0 0 1 0 0 0 1 0\n" +
                   cells + "CELL_DATA 1\nFIELD FieldData 1\nface 1 1 int\n7\n" + cells);
  EXPECT_EQ(file.mesh.elements.size(), 2u);
  EXPECT_FALSE(file.hasFaces);
}

TEST(ReadMesh, NotesWhatItLeavesOut) {
  const MeshFile file = readText("mixed.vtk",
                                 "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                                 "POINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\nCELLS 4 18\n3 0 1 2\n4 "
                                 "0 1 2 3\n4 0 1 1 2\n3 0 0 1\n"
                                 "CELL_TYPES 4\n5\n10\n9\n5\n");
  EXPECT_EQ(file.mesh.elements.size(), 2u);
  ASSERT_EQ(file.mesh.notes.size(), 3u);
  EXPECT_EQ(file.mesh.notes[0], "left out: 1 element that AF2 does not read: cells of VTK type 10");
  EXPECT_EQ(file.mesh.notes[1], "read as triangles: 1 quadrilateral with two equal corners");
}

TEST(ReadMesh, RefusesFilesThatAreCut) {
  for (const char* const extension : {".vtu", ".vtk", ".msh", ".ply", ".stl"})
    EXPECT_NE(cutFile(extension).find("truncated"), std::string::npos) << cutFile(extension);
}

TEST(ReadMesh, RefusesFilesOfOtherKinds) {
  for (const char* const name : {"x.vtu", "x.vtk", "x.msh", "x.ply", "x.stl"})
    EXPECT_NE(faultOf(name, "solids of a different kind\n").find("is "), std::string::npos) << name;
  EXPECT_NE(faultOf("x.step", "").find("give a file in one of .vtu"), std::string::npos);
  EXPECT_NE(faultOf("x.obj", "v 0 0 0\n").find("contains no elements"), std::string::npos);
  EXPECT_NE(faultOf("y.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n")
                .find("UNSTRUCTURED_GRID"),
            std::string::npos);
}

TEST(ReadMesh, RefusesVerticesThatAreNotThere) {
  EXPECT_NE(faultOf("far.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n").find("uses a vertex"),
            std::string::npos);
  std::string text = kOldMsh;
  text.replace(text.find("3 2 2 9 4 10"), 12, "3 2 2 9 4 11");
  EXPECT_NE(faultOf("far.msh", text).find("the vertex 11, which is not in $Nodes"),
            std::string::npos);
}

TEST(ReadMesh, RefusesCoordinatesThatAreNotFinite) {
  EXPECT_NE(faultOf("inf.msh", std::string(kOldMsh).replace(45, 1, "i")).find("is not a number"),
            std::string::npos);
}

TEST(ReadMesh, RefusesVertexNumbersThatAreNone) {
  for (const char* const number : {"-1", "1e300", "nan", "3"}) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_index\n"
        "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 ";
    EXPECT_NE(faultOf("number.ply", text + number + "\n").find("uses a vertex that"),
              std::string::npos)
        << number;
  }
}

TEST(ReadMesh, RefusesPolygons) {
  EXPECT_NE(faultOf("five.obj", "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\n")
                .find("has 5 corners"),
            std::string::npos);
}

TEST(ReadMesh, DoesNotTrustCounts) {
  EXPECT_NE(faultOf("many.vtk",
                    "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                    "POINTS 4000000000000 float\n0 0 0\n")
                .find("truncated"),
            std::string::npos);
}

}  // namespace
}  // namespace af2::geometry
