// Compressed VTU files, written and read back.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "engine/base/error.h"
#include "geometry/base/words.h"
#include "geometry/io/mesh_files.h"
#include "geometry/reading/read_mesh.h"
#include "tests/support/planar_meshes.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

class CompressedVtu : public ::testing::Test {
 protected:
  testing::TestFolder folder;
  std::filesystem::path file = folder / "mesh.vtu";

  std::string written(const ModelMesh& mesh, bool compress) {
    FileOptions options;
    options.compress = compress;
    writeMesh(mesh, file, options);
    return contentOf(file);
  }
};

TEST_F(CompressedVtu, HoldsTheSameMeshInLessSpace) {
  const ModelMesh grid = squareGrid(150);  // with several blocks for an array
  const std::size_t plain = written(grid, false).size();
  const ModelMesh before = readMesh(file).mesh;
  const std::string packed = written(grid, true);
  EXPECT_LT(packed.size(), plain / 2);
  EXPECT_NE(packed.find("compressor=\"vtkZLibDataCompressor\""), std::string::npos);
  EXPECT_EQ(written(grid, true), packed);
  const ModelMesh after = readMesh(file).mesh;
  EXPECT_EQ(after.vertices, before.vertices);
  EXPECT_EQ(after.elements, before.elements);
  EXPECT_EQ(after.face, before.face);
}

/// With more blocks than are compressed at once.
TEST_F(CompressedVtu, HoldsALargeMesh) {
  const ModelMesh grid = squareGrid(650);
  written(grid, true);
  const ModelMesh after = readMesh(file).mesh;
  EXPECT_EQ(after.vertices, grid.vertices);
  EXPECT_EQ(after.elements.size(), grid.elements.size());
}

TEST_F(CompressedVtu, IsRefusedWhereItIsDamaged) {
  const std::string packed = written(squareGrid(20), true);
  const std::size_t array = packed.find("Name=\"Points\"");
  const std::size_t start = packed.find('\n', array) + 1, end = packed.find('\n', start);
  const auto refuses = [&](const std::string& content) {
    std::ofstream(file, std::ios::binary) << content;
    EXPECT_THROW(readMesh(file), InputError);
  };
  for (const std::size_t at : {start, start + 24, start + 60, (start + end) / 2}) {
    std::string damaged = packed;
    for (std::size_t k = 0; k < 8; ++k) damaged[at + k] = damaged[at + k] == '/' ? 'A' : '/';
    refuses(damaged);
    refuses(std::string(packed).erase(at, end - at));
  }
  std::string other = packed;
  other.replace(other.find("vtkZLibDataCompressor"), 21, "vtkLZ4DataCompressor ");
  refuses(other);
}

}  // namespace
}  // namespace af2::geometry
