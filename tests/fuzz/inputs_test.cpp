// Inputs that once broke a reader: tests/fuzz/inputs holds them, by the reader's name.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/fuzz/reading.h"

namespace af2::fuzz {
namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void tryAll(const std::string& ending, void (*reader)(const std::string&)) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(AF2_SOURCE_DIR "/tests/fuzz/inputs")) {
    if (!entry.path().string().ends_with(ending)) continue;
    ++count;
    EXPECT_NO_THROW(reader(contents(entry.path()))) << entry.path();
  }
  EXPECT_GT(count, 0) << "no inputs " << ending;
}

TEST(KnownInputs, BreakNoReaderOfRuleFiles) { tryAll(".af2", tryRuleFile); }
TEST(KnownInputs, BreakNoReaderOfNetgenRules) { tryAll(".rls", tryRlsFile); }
TEST(KnownInputs, BreakNoReaderOfDomains) {
  tryAll(".poly", tryPolyFile);
  tryAll(".in2d", tryIn2dFile);
}
TEST(KnownInputs, BreakNoReaderOfTriangles) {
  tryAll(".stl", tryStlFile);
  tryAll(".obj", tryObjFile);
}
TEST(KnownInputs, BreakNoReaderOfMeshes) {
  tryAll(".vtu", tryVtuFile);
  tryAll(".vtk", tryVtkFile);
  tryAll(".msh", tryMshFile);
  tryAll(".ply", tryPlyFile);
  tryAll(".off", tryOffFile);
}
TEST(KnownInputs, BreakNoReaderOfSizes) {
  tryAll(".size.json", trySizeFile);
  tryAll(".pos", tryPosFile);
  tryAll(".edge_point.json", tryEdgePointFile);
}

}  // namespace
}  // namespace af2::fuzz
