#include "geometry/reading/size_field.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/base/error.h"
#include "geometry/io/mesh_files.h"
#include "tests/support/small_meshes.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

class SizeField : public ::testing::Test {
 protected:
  std::string written(const std::string& name, const std::string& text) const {
    return folder.write(name, text).string();
  }

  testing::TestFolder folder;
};

SizeCells readField(const std::string& text) { return readSizeField(sizeFieldName(text)); }

std::string faultOfField(const std::string& text) {
  try {
    readField(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool hasPart(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const char* const kView =
    "// sizes\nView \"h\" {\nSP(0,0,0){0.5};\nSL(0,0,0, 1,0,0){0.5,0.25};\n"
    "ST(0,0,0,1,0,0,0,1,0){0.5,0.25,1, 7,8,9};\nSQ(0,0,0,1,0,0,1,1,0,0,1,0){1,1,1,1};\n"
    "SS(0,0,0,1,0,0,0,1,0,0,0,1){1,1,1,2};\nVP(0,0,0){1,2,3};\n};\n";

TEST_F(SizeField, IsAViewOfGmsh) {
  const SizeCells cells = readField(written("one.pos", kView));
  EXPECT_EQ(cells.cells.size(), 6u);  // the quadrilateral is two
  EXPECT_EQ(cells.vertices.size(), 5u);
  const auto place = std::ranges::find(cells.vertices, Point3{1, 0, 0});
  ASSERT_NE(place, cells.vertices.end());
  EXPECT_EQ(cells.sizes[static_cast<std::size_t>(place - cells.vertices.begin())], 0.25);  // least
}

TEST_F(SizeField, IsChosenByNameAmongSeveral) {
  const std::string two = written("two.pos", std::string(kView) + "View \"k\" { SP(1,2,3){4}; };");
  EXPECT_EQ(readField(two + ":k").sizes, (std::vector<double>{4}));
  EXPECT_TRUE(hasPart(faultOfField(two), "there is h and k; h (VP) cannot be used; name one"))
      << faultOfField(two);
  EXPECT_TRUE(hasPart(faultOfField(two + ":x"), "has no array 'x'; there is h and k"))
      << faultOfField(two + ":x");
}

TEST_F(SizeField, IsThePointArrayThatAf2WritesOrAnyOther) {
  ModelMesh mesh = cubeMesh();
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    mesh.wantedSizes.push_back(1 + mesh.vertices[v].z);
  const auto path = folder / "cube.vtu";
  for (const bool compress : {false, true}) {
    writeMesh(mesh, path, {LinesAlong::Boundaries, {}, compress});
    const SizeCells cells = readField(path.string());
    EXPECT_EQ(cells.cells.size(), 12u);
    ASSERT_EQ(cells.vertices.size(), 8u);
    for (std::size_t v = 0; v < 8; ++v) EXPECT_EQ(cells.sizes[v], 1 + cells.vertices[v].z);
  }
}

std::string mshWith(const std::string& data) {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"
         "9 5 5 5\n$EndNodes\n$Elements\n2\n1 4 2 1 1 1 2 3 4\n2 2 2 1 1 1 2 9\n$EndElements\n" +
         data;
}

TEST_F(SizeField, IsNodeDataOfAMeshAndLeavesOutCellsWithoutValues) {
  const std::string data =
      "$NodeData\n1\n\"size\"\n1\n0\n3\n0\n1\n4\n1 0.1\n2 0.2\n3 0.3\n4 0.4\n$EndNodeData\n"
      "$NodeData\n1\n\"size\"\n1\n1\n3\n1\n1\n1\n1 7\n$EndNodeData\n"
      "$NodeData\n1\n\"speed\"\n1\n0\n3\n0\n3\n1\n1 7 7 7\n$EndNodeData\n";
  const SizeCells cells = readField(written("data.msh", mshWith(data)));
  ASSERT_EQ(cells.cells.size(), 1u);  // the tetrahedron
  EXPECT_EQ(cells.sizes, (std::vector<double>{0.1, 0.2, 0.3, 0.4}));
}

TEST_F(SizeField, TellsWhatIsWrong) {
  EXPECT_TRUE(hasPart(faultOfField(written("none.msh", mshWith(""))),
                      "has no array with one number for each vertex"));
  EXPECT_TRUE(hasPart(faultOfField(written("negative.pos", "View \"a\" {SP(1,2,3){-4};};")),
                      "the size -4"));
  EXPECT_TRUE(hasPart(faultOfField(written("cut.pos", "View \"a\" {\nSP(1,2,3){4};")),
                      "cut.pos:2: the file ends within the view 'a'"));
  EXPECT_TRUE(hasPart(faultOfField(written("few.pos", "View \"a\" {\nST(1,2,3){4};};")),
                      "ST needs 9 coordinates"));
  EXPECT_TRUE(hasPart(faultOfField(written("old.pos", "$PostFormat\n1.4 1 8\n")), "as text"));
  EXPECT_TRUE(hasPart(faultOfField(written("empty.pos", "")), "is empty"));
  EXPECT_TRUE(hasPart(faultOfField(written("a.stl", "solid")), "give an .msh, .pos or .vtu file"));
  EXPECT_FALSE(faultOfField("there is no such file.pos").empty());
}

}  // namespace
}  // namespace af2::geometry
