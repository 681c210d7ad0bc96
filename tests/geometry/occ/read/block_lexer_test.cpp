#include "geometry/occ/step/block_lexer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "geometry/base/words.h"
#include "geometry/occ/model/model.h"
#include "tests/support/test_folder.h"

namespace af2::geometry {
namespace {

const std::string kText = contentOf(AF2_SOURCE_DIR "/examples/models/cylinder.step");

/// The names of the faces of a cylinder, with a name for one of them, and text before the data.
std::vector<std::string> namesOfFaces(const std::string& name, const std::string& before) {
  std::string text = kText;
  text.insert(text.find("ADVANCED_FACE('") + 15, name);
  text.insert(text.find("#1 ="), before);
  const testing::TestFile file("cylinder.step", text);
  const Model model = readModel(file.path());
  std::vector<std::string> names;
  for (int id = 1; id <= model.faceCount(); ++id) names.push_back(model.faceName(id));
  return names;
}

TEST(BlockLexer, IsThatOfTheLibrary) {
  EXPECT_TRUE(giveLexerBlocks());
  EXPECT_TRUE(giveLexerBlocks());
}

/// The buffer of the lexer has 16384 characters, and is filled by up to 8192.
TEST(BlockLexer, ReadsWordsAcrossTheEndsOfBlocks) {
  const std::string name(300, 'n');
  const std::vector<std::string> names = namesOfFaces(name, "");
  EXPECT_EQ(std::ranges::count(names, name), 1);
  for (std::size_t length = 1; length < 8192; length += 127)
    EXPECT_EQ(namesOfFaces(name, "/*" + std::string(length, '.') + "*/"), names) << length;
}

/// OpenCASCADE's lexer cannot read longer ones, however it gets its text.
TEST(BlockLexer, ReadsWordsThatFillItsBuffer) {
  const std::string name(16'370, 'n');
  for (const std::size_t length : {1u, 1000u, 8000u, 16'000u})
    EXPECT_EQ(std::ranges::count(namesOfFaces(name, "/*" + std::string(length, '.') + "*/"), name),
              1)
        << length;
}

}  // namespace
}  // namespace af2::geometry
